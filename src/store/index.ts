export { Address, type AddressBar, type After } from './address.ts';
export { AddressedView } from './addressed-view.ts';
export { Addresses } from './addresses.ts';
export { type Command, type CommandId, Commands, type KeyPress, type OfferedId } from './commands.ts';
export { Devices } from './devices.ts';
export { type BrokenAddress, Page } from './page.ts';
export { type Imported, type Naming, SavedFrames } from './saved-frames.ts';
export { KeptChoice, PageStorage, StoredList } from './storage.ts';
export { addressOf, type OtherView, otherViews, partsAt, type ViewParts, viewAt } from './views.ts';
