package arcomat.pipeline;

import org.eclipse.jdt.internal.compiler.classfmt.ClassFileReader;
import org.eclipse.jdt.internal.compiler.classfmt.ClassFormatException;
import org.eclipse.jdt.internal.compiler.env.INameEnvironment;
import org.eclipse.jdt.internal.compiler.env.NameEnvironmentAnswer;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** What a compiler may refer to: the classes that this program itself runs on. */
final class LoadedTypes implements INameEnvironment, AutoCloseable {
    private static final Set<String> ROOTS = Set.of("java", "java.lang", "arcomat", "arcomat.rt");

    private final Map<String, Optional<NameEnvironmentAnswer>> known = new HashMap<>();
    private final Set<String> packages = new HashSet<>(ROOTS);

    /**
     * @param sources paths of the files that are compiled together
     */
    LoadedTypes(Set<String> sources) {
        for (String path : sources) {
            int end = path.lastIndexOf('/');
            while (end > 0 && packages.add(path.substring(0, end).replace('/', '.'))) {
                end = path.lastIndexOf('/', end - 1);
            }
        }
    }

    @Override
    public NameEnvironmentAnswer findType(char[][] compoundTypeName) {
        return find(join(compoundTypeName, compoundTypeName.length, '/'));
    }

    @Override
    public NameEnvironmentAnswer findType(char[] typeName, char[][] packageName) {
        String folder = join(packageName, packageName.length, '/');
        return find((folder.isEmpty() ? "" : folder + "/") + new String(typeName));
    }

    private NameEnvironmentAnswer find(String name) {
        return known.computeIfAbsent(name, LoadedTypes::read).orElse(null);
    }

    private static Optional<NameEnvironmentAnswer> read(String name) {
        if (!name.startsWith("java/") && !name.startsWith("arcomat/rt/")) {
            return Optional.empty();
        }
        String file = name + ".class";
        try (InputStream stream = LoadedTypes.class.getClassLoader().getResourceAsStream(file)) {
            return stream == null
                    ? Optional.empty()
                    : Optional.of(
                            new NameEnvironmentAnswer(
                                    new ClassFileReader(stream.readAllBytes(), file.toCharArray()),
                                    null));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (ClassFormatException e) {
            throw new IllegalStateException(name, e);
        }
    }

    @Override
    public boolean isPackage(char[][] parentPackageName, char[] packageName) {
        int parents = parentPackageName == null ? 0 : parentPackageName.length;
        String parent = parents == 0 ? "" : join(parentPackageName, parents, '.') + ".";
        return packages.contains(parent + new String(packageName));
    }

    private static String join(char[][] names, int count, char separator) {
        StringBuilder joined = new StringBuilder();
        for (int i = 0; i < count; i++) {
            joined.append(i == 0 ? "" : String.valueOf(separator)).append(names[i]);
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
