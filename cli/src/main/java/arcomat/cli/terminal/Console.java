package arcomat.cli.terminal;

import arcomat.report.text.Style;

import org.jspecify.annotations.Nullable;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.IntConsumer;
import java.util.function.Supplier;

/**
 * Where a command runs and whom it talks to.
 *
 * @param directory the folder that relative paths start from
 * @param out results
 * @param err progress and complaints about the use of the command
 * @param watched whether somebody looks on, who wants to be told that long work goes on
 * @param halt ends the process with an exit status, at once; nothing where there is more in it
 * @param loss why not all results could be written
 */
public record Console(
        Path directory,
        PrintWriter out,
        PrintWriter err,
        BufferedReader in,
        Style style,
        boolean watched,
        IntConsumer halt,
        Supplier<Optional<String>> loss) {

    /** Set by the start script where standard error is a terminal: Java cannot find out. */
    private static final String WATCHED = "arcomat.watched";

    /** Set by the start script to the width of the terminal that standard output is. */
    private static final String COLUMNS = "arcomat.columns";

    /** Inside another program, which knows itself what becomes of the results. */
    public static Console quiet(
            Path directory, PrintWriter out, PrintWriter err, BufferedReader in) {
        return new Console(
                directory, out, err, in, Style.PLAIN, false, status -> {}, Optional::empty);
    }

    /** The console of the process. */
    public static Console ofProcess() {
        java.io.Console terminal = System.console();
        Charset charset = charset(terminal);
        ResultStream results = ResultStream.ofProcess();
        return new Console(
                Path.of("").toAbsolutePath(),
                writer(results, charset),
                writer(System.err, charset),
                new BufferedReader(new InputStreamReader(System.in, charset)),
                style(terminal != null && wantsColour()),
                Boolean.getBoolean(WATCHED),
                Runtime.getRuntime()::halt,
                results::loss);
    }

    private static Style style(boolean coloured) {
        Style style = coloured ? Style.COLOURED : Style.PLAIN;
        int width = Integer.getInteger(COLUMNS, 0);
        return width > 0 ? style.within(width) : style;
    }

    /** That of a terminal, if it can show more than ASCII. All else reads UTF-8. */
    private static Charset charset(java.io.@Nullable Console terminal) {
        Charset own = terminal == null ? StandardCharsets.US_ASCII : terminal.charset();
        return own.equals(StandardCharsets.US_ASCII) ? StandardCharsets.UTF_8 : own;
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
