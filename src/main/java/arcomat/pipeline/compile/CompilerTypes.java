package arcomat.pipeline.compile;

import org.eclipse.jdt.internal.compiler.batch.CompilationUnit;
import org.eclipse.jdt.internal.compiler.classfmt.ClassFileReader;
import org.eclipse.jdt.internal.compiler.classfmt.ClassFormatException;
import org.eclipse.jdt.internal.compiler.env.INameEnvironment;
import org.eclipse.jdt.internal.compiler.env.NameEnvironmentAnswer;
import org.jspecify.annotations.Nullable;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What a compiler may refer to: sources that it compiles anyway, sources that it compiles where
 * something refers to them, and class files.
 */
final class CompilerTypes implements INameEnvironment, AutoCloseable {
    private static final String ENDING = ".java";

    private final Map<String, String> onDemand;
    private final ClassFiles classes;
    private final Map<String, Optional<NameEnvironmentAnswer>> known = new HashMap<>();
    private final Set<String> packages = new HashSet<>();

    /**
     * @param sources paths of the files that are compiled together
     * @param onDemand texts by path
     */
    CompilerTypes(Set<String> sources, Map<String, String> onDemand, ClassFiles classes) {
        this.onDemand = onDemand;
        this.classes = classes;
        sources.forEach(this::addPackages);
        onDemand.keySet().forEach(this::addPackages);
    }

    private void addPackages(String path) {
        int end = path.lastIndexOf('/');
        while (end > 0 && packages.add(path.substring(0, end))) {
            end = path.lastIndexOf('/', end - 1);
        }
    }

    @Override
    public @Nullable NameEnvironmentAnswer findType(char[][] compoundTypeName) {
        return find(join(compoundTypeName));
    }

    @Override
    public @Nullable NameEnvironmentAnswer findType(char[] typeName, char[][] packageName) {
        String folder = join(packageName);
        return find((folder.isEmpty() ? "" : folder + "/") + new String(typeName));
    }

    private @Nullable NameEnvironmentAnswer find(String name) {
        return known.computeIfAbsent(name, this::read).orElse(null);
    }

    private Optional<NameEnvironmentAnswer> read(String name) {
        String path = name + ENDING;
        String source = onDemand.get(path);
        if (source != null) {
            CompilationUnit unit = new CompilationUnit(source.toCharArray(), path, "UTF-8");
            return Optional.of(new NameEnvironmentAnswer(unit, null));
        }
        return classes.find().apply(name).map(file -> answer(file, name));
    }

    private static NameEnvironmentAnswer answer(byte[] file, String name) {
        try {
            return new NameEnvironmentAnswer(new ClassFileReader(file, name.toCharArray()), null);
        } catch (ClassFormatException e) {
            throw new IllegalStateException(name, e);
        }
    }

    @Override
    public boolean isPackage(char @Nullable [][] parentPackageName, char[] packageName) {
        String parent = parentPackageName == null ? "" : join(parentPackageName);
        String name = (parent.isEmpty() ? "" : parent + "/") + new String(packageName);
        return packages.contains(name) || classes.isPackage().test(name);
    }

    private static String join(char[][] names) {
        StringBuilder joined = new StringBuilder();
        for (char[] name : names) {
            joined.append(joined.length() == 0 ? "" : "/").append(name);
        }
        return joined.toString();
    }

    @Override
    public void cleanup() {
        known.clear();
    }

    @Override
    public void close() {
        cleanup();
    }
}
