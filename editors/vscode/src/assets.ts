import { createHash } from 'node:crypto';
import * as vscode from 'vscode';

/** Files of the folder `view`: what pages in a side view run and look like. */
export class Assets {
  constructor(private readonly extension: vscode.Uri) {}

  async text(name: string): Promise<string> {
    const file = vscode.Uri.joinPath(this.extension, 'view', name);
    return Buffer.from(await vscode.workspace.fs.readFile(file)).toString('utf8');
  }

  /** A page of our own. Nothing runs in it but these scripts: whatever models call their things stays text. */
  async page(body: string, style: string, scripts: readonly string[]): Promise<string> {
    const texts = await Promise.all(scripts.map((name) => this.text(name)));
    const allowed = texts.map((text) => `'${hash(text)}'`).join(' ');
    return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; script-src ${allowed}">
</head>
<body>
${body}
<style>${await this.text(style)}</style>
${texts.map((text) => `<script>${text}</script>`).join('\n')}
</body>
</html>`;
  }
}

/** As a page's policy names a style or a script. */
export function hash(text: string): string {
  return `sha256-${createHash('sha256').update(text, 'utf8').digest('base64')}`;
}
