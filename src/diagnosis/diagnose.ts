import { toHex } from '../modbus/index.ts';
import { type DiagnoseContext, isClean, makeCase } from './case.ts';
import { CERTAIN, LIKELY } from './evidence.ts';
import type { Confidence, Finding, FindingCode, Offer } from './finding.ts';
import { findingKinds } from './finding-kinds.ts';
import { isSound } from './frames.ts';
import { ofOthers, ofSoundFrames } from './hypotheses/index.ts';

/** A finding that is less likely than the first by this many bits is not worth reading. */
const WORTH = 12;
const MOST_FINDINGS = 6;
const CARRIED = ['rtu', 'tcp', 'ascii'] as const;
const ANY = [...CARRIED, 'pdu'] as const;

/**
 * Says why bytes fail as a frame, or that nothing is wrong with them: the findings, the one that explains most first.
 * Their `repaired` frames are valid. Never throws. Only the first 4096 bytes are examined; without bytes there are no
 * findings.
 */
export function diagnose(bytes: Uint8Array, context: DiagnoseContext = {}): Finding[] {
  if (bytes.length === 0) return [];
  const item = makeCase(bytes, context);
  const awaited = item.wholes.filter(({ reading }) => !item.request || reading.direction === 'response');
  const hypotheses = awaited.some(isClean) ? ofSoundFrames : [...ofSoundFrames, ...ofOthers];
  const offers = hypotheses
    .flatMap((hypothesis) => hypothesis.offer(item))
    .sort((a, b) => b.bits - a.bits)
    // Unexplained noise is reported only if there is no other finding.
    .filter((offer, index) =>
      index > 0 && isUnknown(offer) ? false : offer.bits > 0 || (index === 0 && offer.bits === 0),
    );
  const proof = item.transport === 'pdu' ? ANY : CARRIED;
  return chosen(offers).map((offer) => finding(offer, offers, (frame) => isSound(frame, proof)));
}

const isUnknown = (offer: Offer): boolean => offer.code === 'noise' && offer.pattern === 'unknown';

/** The best offer of each code, of those worth reading beside the best one. */
function chosen(offers: readonly Offer[]): Offer[] {
  const seen = new Set<FindingCode>();
  const [best] = offers;
  const sound = best?.code === 'valid' || best?.code === 'valid-exception';
  return offers
    .filter(({ code, bits }) => {
      const explained = code === 'crc-wrong' && [...seen].some((before) => findingKinds[before] === 'crc-cause');
      if (seen.has(code) || explained) return false;
      seen.add(code);
      // Beside a sound frame there are only hints, which always have little evidence.
      return sound || bits > (best?.bits ?? 0) - WORTH;
    })
    .slice(0, MOST_FINDINGS);
}

/** The finding of an offer, with the repairs of all offers of its code. */
function finding(offer: Offer, offers: readonly Offer[], isRepair: (frame: Uint8Array) => boolean): Finding {
  const { bits, guess, ...found } = offer;
  const same = offers.filter(({ code }) => code === offer.code);
  const repairs = new Map<string, Uint8Array>();
  for (const { repaired } of same) for (const frame of repaired) if (isRepair(frame)) repairs.set(toHex(frame), frame);
  const confidence: Confidence = guess
    ? 'possible'
    : bits >= CERTAIN
      ? 'certain'
      : bits >= LIKELY
        ? 'likely'
        : 'possible';
  const repaired = [...repairs.values()];
  const others = found.code === 'byte-error' ? { others: Math.max(0, repaired.length - 1) } : {};
  return { ...found, ...others, confidence, repaired } as Finding;
}
