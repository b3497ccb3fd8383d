/** The parts of a PowerShell program that no frame changes. */

const SEND_SERIAL = `
# Sends a request, after the silence that parts it from what was sent before.
function Send($line, [byte[]] $request) {
    Start-Sleep -Milliseconds $Pause
    $line.DiscardInBuffer()
    $line.Write($request, 0, $request.Length)
}
`;

const SEND_TCP = `
# Sends a request.
function Send($line, [byte[]] $request) {
    $line.Write($request, 0, $request.Length)
}
`;

const READ_ECHO = `
    # The adapter gives back what is sent.
    for ($echoed = 0; $echoed -lt $request.Length; $echoed++) {
        $line.ReadTimeout = $Timeout
        try { [void] $line.ReadByte() } catch [System.TimeoutException] { break }
    }`;

const exchangePart = (isTcp: boolean, echo: boolean) => `
# Sends a request and gives what comes back, until all of it is there or the time is over.
function Exchange($line, [byte[]] $request, [string] $wanted) {
    Send $line $request${echo ? READ_ECHO : ''}
    $clock = [System.Diagnostics.Stopwatch]::StartNew()
    $reply = [System.Collections.Generic.List[byte]]::new()
    while ($true) {
        $length = & $wanted $reply.ToArray() $reply.Count
        if (($length -gt 0) -and ($reply.Count -ge $length)) { break }
        $left = [int] [Math]::Max(1, $Timeout - $clock.ElapsedMilliseconds)
${
  isTcp
    ? '        $line.ReadTimeout = $left'
    : `        # Where no byte says how long the reply is, silence ends it.
        if (($length -eq 0) -and ($reply.Count -gt 0)) { $left = [Math]::Min($left, $Silence) }
        $line.ReadTimeout = $left`
}
        try { $more = $line.ReadByte() } catch [System.${isTcp ? 'IO.IOException' : 'TimeoutException'}] { break }
        if ($more -lt 0) { break }
        $reply.Add($more)
    }
    return , $reply.ToArray()
}
`;

/** How the program speaks over the line; `answered` says whether any reply is waited for. */
export const exchangeParts = (isTcp: boolean, echo: boolean, answered: boolean): readonly string[] => [
  isTcp ? SEND_TCP : SEND_SERIAL,
  ...(answered ? [exchangePart(isTcp, echo)] : []),
];

export const VERDICT = `
# Says in words what a check gives.
function Verdict([int] $result) {
    if ($result -gt 0) { return "exception $($result): $(ExceptionName $result)" }
    if ($result -lt 0) { return "fault $($result): $(FaultName $result)" }
    return 'good'
}
`;

export const WAIT_UNTIL = `
# Asks every interval whether something holds, and gives up after the time-out; both in milliseconds.
function WaitUntil([scriptblock] $holds, [int] $interval, [int] $timeout) {
    $clock = [System.Diagnostics.Stopwatch]::StartNew()
    for ($due = $interval; -not (& $holds); $due += $interval) {
        if ($due -gt $timeout) { return $false }
        Start-Sleep -Milliseconds ([Math]::Max(0, $due - $clock.ElapsedMilliseconds))
    }
    return $true
}
`;

/** The lines of a part; without comments, if there are to be none. */
export const partLines = (part: string, comments: boolean): readonly string[] =>
  part
    .trim()
    .split('\n')
    .filter((line) => comments || !line.trim().startsWith('#'));
