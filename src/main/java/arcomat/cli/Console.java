package arcomat.cli;

import arcomat.report.text.Style;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/**
 * Where a command runs and whom it talks to.
 *
 * @param directory the folder that relative paths start from
 * @param out results
 * @param err progress and complaints about the use of the command
 * @param patient whether nobody needs to be told that long work goes on
 */
public record Console(
        Path directory,
        PrintWriter out,
        PrintWriter err,
        BufferedReader in,
        Style style,
        boolean patient) {

    /** The console of the process. */
    static Console ofProcess() {
        java.io.Console terminal = System.console();
        Charset charset = terminal == null ? StandardCharsets.UTF_8 : terminal.charset();
        return new Console(
                Path.of("").toAbsolutePath(),
                writer(System.out, charset),
                writer(System.err, charset),
                new BufferedReader(new InputStreamReader(System.in, charset)),
                terminal != null && wantsColour() ? Style.COLOURED : Style.PLAIN,
                false);
    }

    private static PrintWriter writer(OutputStream stream, Charset charset) {
        return new PrintWriter(new OutputStreamWriter(stream, charset));
    }

    /** As agreed on no-color.org: any text in NO_COLOR switches colours off. */
    private static boolean wantsColour() {
        String noColour = System.getenv("NO_COLOR");
        return (noColour == null || noColour.isEmpty()) && !"dumb".equals(System.getenv("TERM"));
    }
}
