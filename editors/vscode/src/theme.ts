import * as vscode from 'vscode';

export function isDark(): boolean {
  const kind = vscode.window.activeColorTheme.kind;
  return kind === vscode.ColorThemeKind.Dark || kind === vscode.ColorThemeKind.HighContrast;
}

/** Colours of a page or picture follow the browser; here they follow the theme. */
export function inTheme(text: string, dark: boolean): string {
  return text
    .replaceAll('@media (prefers-color-scheme: dark)', dark ? '@media all' : '@media not all')
    .replaceAll('color-scheme: light dark', dark ? 'color-scheme: dark' : 'color-scheme: light');
}
