import { Component } from 'preact';
import { type Profile, writeProfiles } from '../../../devices/index.ts';
import { type Imported, importProfiles, LARGEST_PROFILES, writeProfileCsv } from '../../../workbench/index.ts';
import { download } from '../../kit/download.ts';
import { FileButton } from '../../kit/file-button.tsx';
import { parseCsv } from '../../parts/csv.ts';
import { allDevices } from '../../parts/device/chosen.ts';
import { deviceWords as words } from '../../parts/device/device-words.ts';

const importText = (text: string, name: string): Imported =>
  importProfiles({ list: allDevices().list, parse: parseCsv, words }, text, name);

interface ExchangeProps {
  readonly profile: Profile | undefined;
  readonly onImported: (imported: Imported) => void;
  readonly onSaid: (said: string) => void;
}

const fileName = ({ name }: Profile, ending: string) =>
  `${name.replace(/[^\p{L}\p{N}.-]+/gu, '-').replace(/^-|-$/g, '') || 'device'}.${ending}`;

/** A device out to a file, and in from one or from what is pasted. */
export class Exchange extends Component<ExchangeProps, { pasted: string }> {
  override state = { pasted: '' };

  private readonly importFile = async (file: File): Promise<void> => {
    const text = file.size > LARGEST_PROFILES ? undefined : await file.text().catch(() => undefined);
    if (text === undefined) this.props.onSaid(file.size > LARGEST_PROFILES ? words.fileTooBig : words.fileUnread);
    else this.props.onImported(importText(text, file.name.replace(/\.[^.]*$/, '')));
  };

  private export(profile: Profile, ending: 'csv' | 'json'): void {
    const name = fileName(profile, ending);
    if (ending === 'csv') download(writeProfileCsv(profile), name, 'text/csv');
    else download(writeProfiles([profile]), name);
    this.props.onSaid(words.exported(name));
  }

  render() {
    const { profile, onImported } = this.props;
    return (
      <>
        {profile && (
          <p class="device-actions">
            <button type="button" onClick={() => this.export(profile, 'csv')}>
              {words.exportCsv}
            </button>
            <button type="button" onClick={() => this.export(profile, 'json')}>
              {words.exportJson}
            </button>
          </p>
        )}
        <details class="device-import">
          <summary>{words.import}</summary>
          <FileButton
            label={words.importFile}
            accept=".csv,.tsv,.txt,.json,text/csv,application/json"
            onFile={(file) => void this.importFile(file)}
          />
          <label>
            {words.paste}
            <textarea
              class="mono"
              rows={4}
              spellcheck={false}
              value={this.state.pasted}
              onInput={({ currentTarget }) => this.setState({ pasted: currentTarget.value })}
            />
          </label>
          <button
            type="button"
            disabled={this.state.pasted.trim() === ''}
            onClick={() => onImported(importText(this.state.pasted, words.pastedName))}
          >
            {words.importPasted}
          </button>
        </details>
      </>
    );
  }
}
