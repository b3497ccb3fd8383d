import { useWords } from '../../parts/words.ts';

/** Which mark of the device each wire of the adapter goes to. */
const pictures = { right: [0, 1, 2], exchanged: [1, 0, 2] } as const;

const [WIDTH, ROW, TOP, BOX] = [120, 20, 34, 104];

/** Three wires between two devices, as they belong, and with two of them exchanged. */
export function WiresPicture() {
  const { picture: words } = useWords('noAnswer');
  const y = (at: number) => TOP + ROW * at;
  return (
    <div class="wires in-row">
      {(['right', 'exchanged'] as const).map((which) => (
        <figure key={which}>
          <svg viewBox={`0 0 ${WIDTH + 2 * BOX} ${y(3)}`} role="img" aria-label={words[which]}>
            {([0, WIDTH + BOX] as const).map((x) => (
              <g key={x}>
                <rect x={x + 0.5} y="0.5" width={BOX - 1} height={y(3) - 1} rx="4" />
                <text class="name" x={x + BOX / 2} y="15">
                  {x === 0 ? words.adapter : words.device}
                </text>
                {words.wires.map((wire, at) => (
                  <text key={wire} x={x + BOX / 2} y={y(at) + 4}>
                    {wire}
                  </text>
                ))}
              </g>
            ))}
            {pictures[which].map((to, from) => (
              <path
                key={from}
                data-wire={from}
                d={`M ${BOX} ${y(from)} h 24 L ${BOX + WIDTH - 24} ${y(to)} h 24`}
                stroke-dasharray={['', '7 3', '2 3'][from]}
              />
            ))}
          </svg>
          <figcaption class="said">{words[which]}</figcaption>
        </figure>
      ))}
    </div>
  );
}
