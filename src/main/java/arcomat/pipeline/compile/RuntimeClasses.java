package arcomat.pipeline.compile;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.Set;

/** The classes that this program itself runs on, as far as generated code may use them. */
final class RuntimeClasses implements ClassFiles {
    private static final Set<String> PACKAGES =
            Set.of("java", "java/lang", "arcomat", "arcomat/rt");

    @Override
    public Optional<byte[]> find(String name) {
        if (!name.startsWith("java/") && !name.startsWith("arcomat/rt/")) {
            return Optional.empty();
        }
        String file = name + ".class";
        try (InputStream in = RuntimeClasses.class.getClassLoader().getResourceAsStream(file)) {
            return in == null ? Optional.empty() : Optional.of(in.readAllBytes());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public boolean isPackage(String name) {
        return PACKAGES.contains(name);
    }
}
