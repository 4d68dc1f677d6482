package arcomat.maven.descriptor;

import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.DocTrees;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreePathScanner;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/**
 * What the sources say about classes and their fields, for people who do not read sources. Compiled
 * classes do not have it any more.
 *
 * @param texts by the name of the class, or that and {@code #field}
 */
record Descriptions(Map<String, String> texts) {

    /** Of all sources in a folder. */
    static Descriptions in(Path folder) throws IOException {
        List<Path> sources;
        try (Stream<Path> files = Files.walk(folder)) {
            sources = files.filter(each -> each.toString().endsWith(".java")).toList();
        }
        Map<String, String> texts = new HashMap<>();
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null)) {
            JavacTask task =
                    (JavacTask)
                            compiler.getTask(
                                    null,
                                    files,
                                    null,
                                    null,
                                    null,
                                    files.getJavaFileObjectsFromPaths(sources));
            Comments comments = new Comments(DocTrees.instance(task), texts);
            for (CompilationUnitTree unit : task.parse()) {
                comments.scan(unit, unit.getPackageName().toString());
            }
        }
        return new Descriptions(texts);
    }

    /**
     * @throws IllegalArgumentException where there is nothing: a goal or a setting that nobody can
     *     look up is not finished
     */
    String of(String name) {
        String text = texts.get(name);
        if (text == null) {
            throw new IllegalArgumentException(name + " has no comment, which says what it is for");
        }
        return text;
    }

    /** Walks through sources, with the name of what a definition is in. */
    private static final class Comments extends TreePathScanner<Void, String> {
        private final DocTrees docs;
        private final Map<String, String> texts;

        Comments(DocTrees docs, Map<String, String> texts) {
            this.docs = docs;
            this.texts = texts;
        }

        @Override
        public Void visitClass(ClassTree type, String in) {
            String name = in + "." + type.getSimpleName();
            take(name);
            return super.visitClass(type, name);
        }

        @Override
        public Void visitVariable(VariableTree variable, String in) {
            take(in + "#" + variable.getName());
            return super.visitVariable(variable, in);
        }

        private void take(String name) {
            String comment = docs.getDocComment(getCurrentPath());
            if (comment != null) {
                texts.put(name, plain(comment));
            }
        }

        private static String plain(String comment) {
            return comment.replaceAll("(?s)\\n\\s*@.*", "")
                    .replaceAll("\\{@\\w+\\s+([^}]*)}", "$1")
                    .replaceAll("\\s+", " ")
                    .strip();
        }
    }
}
