/** Devices come right behind the first view, with their sentences. */
export const loadDevicePanel = () =>
  import('./views.ts').then(async ({ DevicePanel, start }) => {
    await start();
    return DevicePanel;
  });
