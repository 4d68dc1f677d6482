package arcomat.brick;

import arcomat.brick.api.BrickTable;
import arcomat.brick.api.StubJar;
import arcomat.source.SourceFile;

import org.eclipse.jdt.internal.compiler.batch.Main;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * Compiles small programs as a robot's jar is compiled: by Eclipse's compiler, at Java 6, against
 * the stub jar and nothing else; or at a later level against this JDK, as a careless team would.
 */
public final class BrickCompiler {
    private final Path folder;
    private final Path stub;

    /**
     * @param folder an empty one for its files
     */
    public BrickCompiler(Path folder) {
        this.folder = folder;
        this.stub = folder.resolve("stub.jar");
        try (OutputStream out = Files.newOutputStream(stub)) {
            StubJar.write(BrickTable.leJos(), out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * @param classes by internal name; empty where there are errors
     * @param messages what the compiler says
     */
    public record Result(Map<String, byte[]> classes, String messages) {
        /** The classes of a program that is meant to compile. */
        public Map<String, byte[]> orFail() {
            if (classes.isEmpty()) {
                throw new AssertionError(messages);
            }
            return classes;
        }
    }

    /** Compiles files for the brick. */
    public Result forBrick(SourceFile... sources) {
        return compile(List.of("-1.6", "-bootclasspath", stub.toString()), sources);
    }

    /** Compiles one file with one public type, which gives the file its name, for the brick. */
    public Result forBrick(String source) {
        return forBrick(sourceFile(source));
    }

    /** Compiles files for a later Java, against this JDK. */
    public Result forJava(int release, SourceFile... sources) {
        return compile(List.of("--release", "" + release), sources);
    }

    /** A file of the unnamed package, named after its first type. */
    public static SourceFile sourceFile(String text) {
        String name = text.replaceFirst("(?s).*?\\b(?:class|interface|enum) (\\w+).*", "$1");
        return new SourceFile(name + ".java", text);
    }

    private Result compile(List<String> options, SourceFile... sources) {
        try {
            Path work = Files.createTempDirectory(folder, "program");
            Path classes = Files.createDirectory(work.resolve("classes"));
            List<String> arguments = new ArrayList<>(options);
            arguments.addAll(List.of("-g", "-nowarn", "-proc:none", "-d", classes.toString()));
            for (SourceFile source : sources) {
                Path file = work.resolve(source.path());
                Files.createDirectories(file.getParent());
                Files.writeString(file, source.text());
                arguments.add(file.toString());
            }
            StringWriter messages = new StringWriter();
            PrintWriter out = new PrintWriter(messages);
            boolean fine =
                    new Main(out, out, false, null, null).compile(arguments.toArray(new String[0]));
            return new Result(fine ? read(classes) : Map.of(), messages.toString());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Map<String, byte[]> read(Path classes) throws IOException {
        Map<String, byte[]> result = new TreeMap<>();
        try (Stream<Path> files = Files.walk(classes)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                String name = classes.relativize(file).toString().replace('\\', '/');
                result.put(name.replaceFirst("\\.class$", ""), Files.readAllBytes(file));
            }
        }
        return result;
    }
}
