import type { NameRules } from '../names.ts';

/** Keywords of C99 and C++, as programs of C are often compiled as C++. */
const KEYWORDS =
  'alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t class compl const const_cast constexpr continue decltype default delete do double dynamic_cast else enum explicit export extern false final float for friend goto if inline int long mutable namespace new noexcept not not_eq nullptr operator or or_eq override private protected public register reinterpret_cast restrict return short signed sizeof static static_assert static_cast struct switch template this thread_local throw true try typedef typeid typename typeof union unsigned using virtual void volatile wchar_t while xor xor_eq';

/** What the standard library has that a name of these words could be. */
const LIBRARY =
  'abort abs accept access alarm assert atan atexit atof atoi atol bind bsearch calloc ceil chdir chmod chown clock close connect cos creat ctime daemon div dup environ errno exec exit exp fabs fclose fcntl feof fflush fgetc fgets floor fmod fopen fork fprintf fputc fputs fread free freopen fscanf fseek ftell fwrite getc getchar getenv getopt gets ioctl isatty kill labs ldexp link linux listen llabs log longjmp lseek malloc memchr memcmp memcpy memmove memset mkdir mktime modf nice open pause perror pipe poll pow printf putc putchar puts qsort raise rand random read realloc recv remove rename rewind rmdir round scanf select send setbuf setjmp signal sin sinh sleep socket sprintf sqrt srand sscanf stat stderr stdin stdout strcat strchr strcmp strcpy strlen strncpy strtol sync system tan tanh time timer tmpfile truncate trunc tzname umask uname ungetc unix unlink usleep wait write';

/** What the programs themselves have beside the routines of requests. */
const OWN =
  'ask ask_for ask_until check_text exchange float_of main now_ms open_port print_bytes receive report requests run_finally run_steps wait_ms';

const CONSTANTS = 'EOF FRAME_MOST INT_MAX NULL PAUSE_MS RAND_MAX SERVER_PORT SILENCE_MS TIMEOUT_MS';

const words = (...lists: readonly string[]): readonly string[] => lists.flatMap((list) => list.split(' '));

const styles = { routine: 'snake', variable: 'snake', constant: 'constant', table: 'snake', type: 'snake' } as const;

export const cNames: NameRules = { styles, reserved: words(KEYWORDS, LIBRARY, OWN, CONSTANTS) };

/** What Arduino's core has beside that: macros do not care where a name stands. */
const ARDUINO =
  'B0 B1 CHANGE DEC DEFAULT DISABLED EXTERNAL F FALLING HEX HIGH INPUT INTERNAL LOW MODBUS OCT OUTPUT PI PROGMEM PSTR RISING SS SCK SDA SCL MISO MOSI Serial Serial1 String Stream TX RX analogRead analogWrite bitClear bitRead bitSet bitWrite boolean byte client mac constrain degrees delay digitalRead digitalWrite highByte interrupts loop lowByte map max micros millis min noInterrupts noTone pinMode pulseIn radians setup sq tone word yield DIRECTION_PIN SERVER';

export const arduinoNames: NameRules = { styles, reserved: words(KEYWORDS, LIBRARY, OWN, CONSTANTS, ARDUINO) };
