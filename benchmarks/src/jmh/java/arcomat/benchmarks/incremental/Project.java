package arcomat.benchmarks.incremental;

import arcomat.benchmarks.frontend.Texts;
import arcomat.benchmarks.measure.Folders;
import arcomat.cli.Embedded;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * A folder of a thousand models: nine of ten are controllers, and one of ten is made of nine of
 * these.
 */
final class Project implements AutoCloseable {
    /** Nobody uses it. */
    static final String SINGLE = "load/Line50.arc";

    /** A part of {@link #SINGLE}. */
    static final String PART = "load/Controller454.arc";

    static final String STATE = "check.state";

    private static final int LINES = 100;
    private static final int PARTS = 9;

    private final Path folder = Files.createTempDirectory("incremental");
    private int changes;

    Project() throws IOException {
        Files.createDirectory(folder.resolve("load"));
        for (SourceFile model : Texts.models(LINES * PARTS)) {
            Files.writeString(folder.resolve(model.path()), model.text());
        }
        for (int line = 0; line < LINES; line++) {
            Files.writeString(folder.resolve("load/Line" + line + ".arc"), line(line));
        }
    }

    /** Every controller hears the same, and one shows its light. */
    private static String line(int number) {
        StringBuilder text = new StringBuilder("package load;\n\nimport load.Signals.*;\n\n");
        text.append("component Line").append(number).append(" {\n");
        text.append("  port\n    in Request request,\n    in Integer amount,\n");
        for (int part = 0; part < PARTS; part++) {
            text.append("    out Light light").append(part).append(",\n");
            text.append("    out Integer total").append(part);
            text.append(part + 1 < PARTS ? ",\n" : ";\n");
        }
        for (int part = 0; part < PARTS; part++) {
            String name = "part" + part;
            text.append("\n  component Controller").append(number * PARTS + part);
            text.append(' ').append(name).append(";\n");
            text.append("  connect request -> ").append(name).append(".request;\n");
            text.append("  connect amount -> ").append(name).append(".amount;\n");
            text.append("  connect ").append(name).append(".light -> light").append(part);
            text.append(";\n  connect ").append(name).append(".total -> total").append(part);
            text.append(";\n");
        }
        return text.append("}\n").toString();
    }

    /** Another comment: the tool does not know that this means nothing. */
    void change(String path) throws IOException {
        Path file = folder.resolve(path);
        String text = Files.readString(file);
        String model = text.substring(0, text.lastIndexOf('}'));
        Files.writeString(file, model + "} // change " + changes++ + "\n");
    }

    /**
     * Runs the tool.
     *
     * @return what it tells beside the findings
     */
    String check(String... options) throws InterruptedException {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        List<String> arguments =
                Stream.concat(Stream.concat(Stream.of("check"), Stream.of(options)), Stream.of("."))
                        .toList();
        int status =
                Embedded.run(
                        folder,
                        new PrintWriter(out),
                        new PrintWriter(err),
                        arguments.toArray(String[]::new));
        if (status != 0) {
            throw new IllegalStateException(out.toString() + err);
        }
        return err.toString().strip();
    }

    @Override
    public void close() throws IOException {
        Folders.delete(folder);
    }
}
