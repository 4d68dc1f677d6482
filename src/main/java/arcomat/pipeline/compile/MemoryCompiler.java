package arcomat.pipeline.compile;

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
 * Compiles Java source to class files, all in memory: Java 6, where nothing else is said. Eclipse's
 * compiler, since the JDK's own has forgotten Java 6 and needs not be there at run time.
 */
public final class MemoryCompiler {
    private final Map<String, byte[]> classes = new HashMap<>();
    private final Map<String, String> origins = new HashMap<>();
    private final List<Compilation.Problem> problems = new ArrayList<>();

    /**
     * Compiles a set of files that may refer to each other.
     *
     * @param sources texts by path
     * @param onDemand more texts by path, compiled where something refers to them
     * @param available all other classes that may be referred to
     */
    public static Compilation compile(
            Map<String, String> sources, Map<String, String> onDemand, ClassFiles available) {
        return compile(sources, onDemand, available, CompilerOptions.VERSION_1_6);
    }

    /** As above, by the rules of the Java that this program runs on at least. */
    public static Compilation compileForThisJava(
            Map<String, String> sources, ClassFiles available) {
        return compile(sources, Map.of(), available, CompilerOptions.VERSION_17);
    }

    private static Compilation compile(
            Map<String, String> sources,
            Map<String, String> onDemand,
            ClassFiles available,
            String version) {
        MemoryCompiler memory = new MemoryCompiler();
        ICompilationUnit[] units =
                sources.entrySet().stream()
                        .map(MemoryCompiler::unit)
                        .toArray(ICompilationUnit[]::new);
        try (CompilerTypes types = new CompilerTypes(sources.keySet(), onDemand, available)) {
            Compiler compiler =
                    new Compiler(
                            types,
                            DefaultErrorHandlingPolicies.proceedWithAllProblems(),
                            options(version),
                            memory::accept,
                            new DefaultProblemFactory(Locale.ENGLISH));
            compiler.compile(units);
        }
        return new Compilation(memory.classes, memory.origins, memory.problems);
    }

    private static ICompilationUnit unit(Map.Entry<String, String> source) {
        return new CompilationUnit(source.getValue().toCharArray(), source.getKey(), "UTF-8");
    }

    private static CompilerOptions options(String version) {
        return new CompilerOptions(
                Map.of(
                        CompilerOptions.OPTION_Source, version,
                        CompilerOptions.OPTION_Compliance, version,
                        CompilerOptions.OPTION_TargetPlatform, version,
                        CompilerOptions.OPTION_LineNumberAttribute, CompilerOptions.GENERATE));
    }

    private void accept(CompilationResult result) {
        if (!result.hasErrors()) {
            for (ClassFile file : result.getClassFiles()) {
                String name = new String(file.fileName());
                classes.put(name, file.getBytes());
                origins.put(name, new String(result.getFileName()));
            }
            return;
        }
        for (CategorizedProblem problem : result.getErrors()) {
            problems.add(
                    new Compilation.Problem(
                            new String(problem.getOriginatingFileName()),
                            problem.getSourceLineNumber(),
                            problem.getSourceStart(),
                            problem.getSourceEnd() + 1,
                            problem.getMessage(),
                            JavaLimit.of(problem.getID())));
        }
    }
}
