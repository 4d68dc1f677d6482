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
import java.util.stream.Collectors;

/**
 * Compiles Java 6 source to class files, all in memory. Eclipse's compiler, since the JDK's own has
 * forgotten Java 6 and needs not be there at run time.
 */
final class MemoryCompiler {
    private final List<Compilation.CompiledClass> classes = new ArrayList<>();
    private final List<Compilation.Mistake> mistakes = new ArrayList<>();

    /**
     * Compiles a set of files that may refer to each other, to the JDK and to {@code arcomat.rt}.
     *
     * @param sources texts by path
     * @return class files by the qualified name of their class
     * @throws IllegalArgumentException where the text is not Java 6; the message has all errors
     */
    static Map<String, byte[]> compile(Map<String, String> sources) {
        Compilation compilation = compile(sources, new OwnClasses());
        if (!compilation.mistakes().isEmpty()) {
            throw new IllegalArgumentException(
                    compilation.mistakes().stream()
                            .map(m -> m.source() + ":" + m.line() + ": " + m.message())
                            .collect(Collectors.joining("\n")));
        }
        Map<String, byte[]> classes = new HashMap<>();
        compilation.classes().forEach(c -> classes.put(c.name().replace('/', '.'), c.bytes()));
        return classes;
    }

    /**
     * Compiles a set of files that may refer to each other and to some known classes.
     *
     * @param sources texts by path
     */
    static Compilation compile(Map<String, String> sources, ClassSource known) {
        MemoryCompiler memory = new MemoryCompiler();
        ICompilationUnit[] units =
                sources.entrySet().stream()
                        .map(MemoryCompiler::unit)
                        .toArray(ICompilationUnit[]::new);
        try (KnownTypes types = new KnownTypes(sources.keySet(), known)) {
            Compiler compiler =
                    new Compiler(
                            types,
                            DefaultErrorHandlingPolicies.proceedWithAllProblems(),
                            options(),
                            memory::accept,
                            new DefaultProblemFactory(Locale.ENGLISH));
            compiler.compile(units);
        }
        return new Compilation(memory.classes, memory.mistakes);
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
        String path = new String(result.getFileName());
        if (result.hasErrors()) {
            for (CategorizedProblem problem : result.getErrors()) {
                mistakes.add(mistake(path, problem));
            }
            return;
        }
        for (ClassFile file : result.getClassFiles()) {
            String name = new String(file.fileName());
            classes.add(new Compilation.CompiledClass(name, file.getBytes(), path));
        }
    }

    private static Compilation.Mistake mistake(String path, CategorizedProblem problem) {
        return new Compilation.Mistake(
                path,
                problem.getSourceLineNumber(),
                problem.getSourceStart(),
                problem.getSourceEnd() + 1,
                problem.getMessage());
    }
}
