package arcomat.sim;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.load.Program;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;

/** Programs compiled against the simulated classes, in memory. */
final class Compiled {
    private static final Path PROGRAMS = Path.of("src/test/programs");

    private Compiled() {}

    /** The program of a file in the folder of test programs, named like its class. */
    static Program file(String name) {
        try {
            return source(name, Files.readString(PROGRAMS.resolve(name + ".java")));
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    /** A program whose main has this body. */
    static Program main(String... lines) {
        return source(
                "Main",
                """
                import lejos.nxt.*;
                import lejos.nxt.comm.*;
                import lejos.util.*;
                public class Main {
                    public static void main(String[] args) throws Exception {
                        %s
                    }
                }
                """
                        .formatted(String.join("\n", lines)));
    }

    static Program source(String mainClass, String text) {
        return sources(mainClass, Map.of(mainClass, text));
    }

    /** A program of several files, by their paths without {@code .java}. */
    static Program sources(String mainClass, Map<String, String> texts) {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        Memory memory = new Memory(compiler.getStandardFileManager(null, null, null));
        List<String> options =
                List.of(
                        "-nowarn",
                        "-source",
                        "8",
                        "-target",
                        "8",
                        "-Xlint:-options",
                        "-classpath",
                        System.getProperty("java.class.path"));
        List<JavaFileObject> sources = new ArrayList<>();
        texts.forEach((path, text) -> sources.add(inMemory(path, text)));
        boolean compiled = compiler.getTask(null, memory, null, options, null, sources).call();
        assertThat(compiled).as("the program compiles").isTrue();
        Map<String, byte[]> classes = new HashMap<>();
        memory.classes.forEach((name, bytes) -> classes.put(name, bytes.toByteArray()));
        return new Program(mainClass, classes);
    }

    private static JavaFileObject inMemory(String path, String text) {
        return new SimpleJavaFileObject(
                URI.create("string:///" + path + ".java"), JavaFileObject.Kind.SOURCE) {
            @Override
            public CharSequence getCharContent(boolean ignoreEncodingErrors) {
                return text;
            }
        };
    }

    private static final class Memory extends ForwardingJavaFileManager<JavaFileManager> {
        private final Map<String, ByteArrayOutputStream> classes = new HashMap<>();

        Memory(JavaFileManager next) {
            super(next);
        }

        @Override
        public JavaFileObject getJavaFileForOutput(
                Location location,
                String name,
                JavaFileObject.Kind kind,
                javax.tools.FileObject sibling) {
            return new SimpleJavaFileObject(URI.create("memory:///" + name), kind) {
                @Override
                public OutputStream openOutputStream() {
                    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
                    classes.put(name, bytes);
                    return bytes;
                }
            };
        }
    }
}
