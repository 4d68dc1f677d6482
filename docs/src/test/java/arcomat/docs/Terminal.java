package arcomat.docs;

import arcomat.cli.Embedded;
import arcomat.rt.Cycle;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;

/**
 * Runs the commands of a page in a folder: {@code arcomat}, {@code javac}, {@code java}, and {@code
 * cat}. {@code $ARCOMAT} is the tool's installation, of which a page needs the runtime.
 */
record Terminal(Path directory) {

    /**
     * @param printed on standard output, without empty lines at its ends
     */
    record Outcome(int status, String printed) {}

    Outcome run(String command) {
        List<String> words =
                Arrays.stream(command.split(" +"))
                        .map(
                                word ->
                                        word.replaceAll("^'(.*)'$", "$1")
                                                .replace(runtime(), rt())
                                                .replace(tool(), classes()))
                        .toList();
        try {
            return switch (words.get(0)) {
                case "arcomat" -> arcomat(words.subList(1, words.size()));
                case "java", "javac" -> java(words);
                case "cat" -> new Outcome(0, withoutEmptyEnds(read(words.get(1))));
                default -> throw new AssertionError("no page may need this: " + command);
            };
        } catch (IOException e) {
            throw new AssertionError(command, e);
        }
    }

    Outcome arcomat(List<String> arguments) {
        StringWriter text = new StringWriter();
        PrintWriter out = new PrintWriter(text);
        PrintWriter err = new PrintWriter(Writer.nullWriter());
        try {
            int status = Embedded.run(directory, out, err, arguments.toArray(String[]::new));
            return new Outcome(status, withoutEmptyEnds(text.toString()));
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    private Outcome java(List<String> words) throws IOException {
        Process process =
                new ProcessBuilder(words)
                        .directory(directory.toFile())
                        .redirectErrorStream(true)
                        .start();
        String printed =
                new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        try {
            return new Outcome(process.waitFor(), withoutEmptyEnds(printed));
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    private String read(String name) throws IOException {
        return Files.readString(directory.resolve(name));
    }

    static String withoutEmptyEnds(String text) {
        return text.replaceAll("\\A\n+", "").stripTrailing();
    }

    private static String runtime() {
        try (InputStream version = Embedded.class.getResourceAsStream("/arcomat-version.txt")) {
            String number = new String(version.readAllBytes(), StandardCharsets.UTF_8).strip();
            return "$ARCOMAT/lib/arcomat-runtime-" + number + ".jar";
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private static String tool() {
        return runtime().replace("arcomat-runtime", "arcomat");
    }

    /** The classes that the runtime's jar of an installation holds. */
    private static String rt() {
        return classesWith(Cycle.class);
    }

    /** Those of the workbench, which guests know. */
    private static String classes() {
        return classesWith(SourceFile.class);
    }

    private static String classesWith(Class<?> one) {
        try {
            return Path.of(one.getProtectionDomain().getCodeSource().getLocation().toURI())
                    .toString();
        } catch (URISyntaxException e) {
            throw new AssertionError(e);
        }
    }
}
