package arcomat.pipeline;

import org.eclipse.jdt.internal.compiler.classfmt.ClassFileReader;
import org.eclipse.jdt.internal.compiler.classfmt.ClassFormatException;
import org.eclipse.jdt.internal.compiler.env.INameEnvironment;
import org.eclipse.jdt.internal.compiler.env.NameEnvironmentAnswer;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Answers a compiler's questions: which types and packages are there? */
final class KnownTypes implements INameEnvironment, AutoCloseable {
    private final ClassSource classes;
    private final Map<String, Optional<NameEnvironmentAnswer>> answers = new HashMap<>();
    private final Set<String> packages = new HashSet<>();

    /**
     * @param sources paths of the files that are compiled together
     * @param classes what they may refer to besides each other
     */
    KnownTypes(Set<String> sources, ClassSource classes) {
        this.classes = classes;
        for (String path : sources) {
            int end = path.lastIndexOf('/');
            while (end > 0 && packages.add(path.substring(0, end))) {
                end = path.lastIndexOf('/', end - 1);
            }
        }
    }

    @Override
    public NameEnvironmentAnswer findType(char[][] compoundTypeName) {
        return find(join(compoundTypeName));
    }

    @Override
    public NameEnvironmentAnswer findType(char[] typeName, char[][] packageName) {
        return find(inside(packageName, typeName));
    }

    private NameEnvironmentAnswer find(String name) {
        return answers.computeIfAbsent(name, this::read).orElse(null);
    }

    private Optional<NameEnvironmentAnswer> read(String name) {
        return classes.classFile(name).map(bytes -> answer(name, bytes));
    }

    private static NameEnvironmentAnswer answer(String name, byte[] bytes) {
        try {
            char[] file = (name + ".class").toCharArray();
            return new NameEnvironmentAnswer(new ClassFileReader(bytes, file), null);
        } catch (ClassFormatException e) {
            throw new IllegalStateException(name, e);
        }
    }

    @Override
    public boolean isPackage(char[][] parentPackageName, char[] packageName) {
        String name = inside(parentPackageName, packageName);
        return packages.contains(name) || classes.isPackage(name);
    }

    private static String inside(char[][] parents, char[] name) {
        String folder = parents == null ? "" : join(parents);
        return (folder.isEmpty() ? "" : folder + "/") + new String(name);
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
        answers.clear();
    }

    @Override
    public void close() {
        cleanup();
    }
}
