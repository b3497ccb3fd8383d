import type { ComponentChildren } from 'preact';
import './messages.css';

interface MessagesProps {
  /** Sentences about what was done last; they are read out. */
  readonly lines: readonly string[];
  /** What stands below them, such as the way back. */
  readonly children?: ComponentChildren;
}

/** What was done last, and the way back from it. */
export const Messages = ({ lines, children }: MessagesProps) => (
  <div class="messages">
    <div role="status">
      {lines.map((line, index) => (
        <p key={index}>{line}</p>
      ))}
    </div>
    {children}
  </div>
);
