package arcomat.pipeline;

import org.eclipse.jdt.core.compiler.CategorizedProblem;
import org.eclipse.jdt.internal.compiler.ClassFile;
import org.eclipse.jdt.internal.compiler.CompilationResult;
import org.eclipse.jdt.internal.compiler.Compiler;
import org.eclipse.jdt.internal.compiler.DefaultErrorHandlingPolicies;
import org.eclipse.jdt.internal.compiler.batch.CompilationUnit;
import org.eclipse.jdt.internal.compiler.env.ICompilationUnit;
import org.eclipse.jdt.internal.compiler.impl.CompilerOptions;
import org.eclipse.jdt.internal.compiler.problem.DefaultProblemFactory;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Compiles Java 6 source to class files, all in memory. Eclipse's compiler, since the JDK's own has
 * forgotten Java 6 and needs not be there at run time.
 */
final class MemoryCompiler {
    private final Map<String, byte[]> classes = new HashMap<>();
    private final List<String> errors = new ArrayList<>();

    /**
     * Compiles a set of files that may refer to each other, to the JDK and to {@code arcomat.rt}.
     *
     * @param sources texts by path
     * @return class files by the qualified name of their class
     * @throws IllegalArgumentException where the text is not Java 6; the message has all errors
     */
    static Map<String, byte[]> compile(Map<String, String> sources) {
        MemoryCompiler memory = new MemoryCompiler();
        ICompilationUnit[] units =
                sources.entrySet().stream()
                        .map(MemoryCompiler::unit)
                        .toArray(ICompilationUnit[]::new);
        try (LoadedTypes types = new LoadedTypes(sources.keySet())) {
            Compiler compiler =
                    new Compiler(
                            types,
                            DefaultErrorHandlingPolicies.proceedWithAllProblems(),
                            options(),
                            memory::accept,
                            new DefaultProblemFactory(Locale.ENGLISH));
            compiler.compile(units);
        }
        if (!memory.errors.isEmpty()) {
            throw new IllegalArgumentException(String.join("\n", memory.errors));
        }
        return memory.classes;
    }

    private static ICompilationUnit unit(Map.Entry<String, String> source) {
        return new CompilationUnit(source.getValue().toCharArray(), source.getKey(), "UTF-8");
    }

    private static CompilerOptions options() {
        return new CompilerOptions(
                Map.of(
                        CompilerOptions.OPTION_Source, CompilerOptions.VERSION_1_6,
                        CompilerOptions.OPTION_Compliance, CompilerOptions.VERSION_1_6,
                        CompilerOptions.OPTION_TargetPlatform, CompilerOptions.VERSION_1_6,
                        CompilerOptions.OPTION_LineNumberAttribute, CompilerOptions.GENERATE));
    }

    private void accept(CompilationResult result) {
        for (ClassFile file : result.getClassFiles()) {
            String name = new String(file.fileName()).replace('/', '.');
            classes.put(name, file.getBytes());
        }
        if (result.hasErrors()) {
            for (CategorizedProblem problem : result.getErrors()) {
                errors.add(
                        new String(problem.getOriginatingFileName())
                                + ":"
                                + problem.getSourceLineNumber()
                                + ": "
                                + problem.getMessage());
            }
        }
    }
}
