package arcomat.benchmarks.frontend;

import arcomat.source.SourceFile;

import com.sun.source.util.JavacTask;

import java.io.IOException;
import java.io.OutputStream;
import java.net.URI;
import java.util.List;

import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;

/** The Java compiler without a disk: sources come from memory, classes go nowhere. */
final class InMemoryJavac {
    private static final JavaCompiler COMPILER = ToolProvider.getSystemJavaCompiler();

    private InMemoryJavac() {}

    /** Parses only. */
    static int parse(List<SourceFile> files) {
        int units = 0;
        try {
            for (Object unit : task(files).parse()) {
                units += unit.hashCode() == 0 ? 0 : 1;
            }
        } catch (IOException impossible) {
            throw new IllegalStateException(impossible);
        }
        return units;
    }

    /** Everything, code included. */
    static boolean compile(List<SourceFile> files) {
        boolean fine = task(files).call();
        if (!fine) {
            throw new IllegalStateException("the Java texts do not compile");
        }
        return fine;
    }

    private static JavacTask task(List<SourceFile> files) {
        JavaFileManager manager = new Nowhere(COMPILER.getStandardFileManager(null, null, null));
        return (JavacTask)
                COMPILER.getTask(
                        null,
                        manager,
                        null,
                        List.of("-proc:none", "-nowarn"),
                        null,
                        files.stream().map(Source::new).toList());
    }

    private static final class Source extends SimpleJavaFileObject {
        private final String text;

        Source(SourceFile file) {
            super(URI.create("memory:///" + file.path()), Kind.SOURCE);
            text = file.text();
        }

        @Override
        public CharSequence getCharContent(boolean ignoreEncodingErrors) {
            return text;
        }
    }

    private static final class Discarded extends SimpleJavaFileObject {
        Discarded(String className) {
            super(URI.create("memory:///" + className.replace('.', '/') + ".class"), Kind.CLASS);
        }

        @Override
        public OutputStream openOutputStream() {
            return OutputStream.nullOutputStream();
        }
    }

    private static final class Nowhere extends ForwardingJavaFileManager<JavaFileManager> {
        Nowhere(JavaFileManager standard) {
            super(standard);
        }

        @Override
        public JavaFileObject getJavaFileForOutput(
                Location location, String name, JavaFileObject.Kind kind, FileObject sibling) {
            return new Discarded(name);
        }
    }
}
