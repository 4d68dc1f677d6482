package arcomat.pipeline;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.Set;

/** The JDK and the runtime of generated code, from the classes that this program runs on. */
final class OwnClasses implements ClassSource {
    private static final Set<String> PACKAGES =
            Set.of("java", "java/lang", "arcomat", "arcomat/rt");

    @Override
    public Optional<byte[]> classFile(String name) {
        if (!name.startsWith("java/") && !name.startsWith("arcomat/rt/")) {
            return Optional.empty();
        }
        ClassLoader loader = OwnClasses.class.getClassLoader();
        try (InputStream stream = loader.getResourceAsStream(name + ".class")) {
            return stream == null ? Optional.empty() : Optional.of(stream.readAllBytes());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public boolean isPackage(String name) {
        return PACKAGES.contains(name);
    }
}
