package arcomat.symbols.names;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.lang.reflect.Modifier;
import java.net.URI;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The table of Java's types says what Java says; newer Java may have more. */
class JavaLibraryTest {
    private static final Path BASE =
            FileSystems.getFileSystem(URI.create("jrt:/")).getPath("/modules/java.base");

    @TestFactory
    Stream<DynamicTest> knowsWhatJavaHas() {
        return Stream.of("java.lang", "java.util", "java.io", "java.time", "java.util.function")
                .map(name -> DynamicTest.dynamicTest(name, () -> check(name)));
    }

    private static void check(String home) throws IOException {
        assertThat(JavaLibrary.isPackage(home)).isTrue();
        List<String> files;
        try (Stream<Path> all = Files.list(BASE.resolve(home.replace('.', '/')))) {
            files = all.map(file -> file.getFileName().toString()).toList();
        }
        for (String file : files) {
            if (file.endsWith(".class") && !file.equals("package-info.class")) {
                check(type(home + "." + file.replace(".class", "")));
            }
        }
    }

    private static Class<?> type(String name) {
        try {
            return Class.forName(name, false, null);
        } catch (ClassNotFoundException e) {
            throw new AssertionError(e);
        }
    }

    private static void check(Class<?> type) {
        if (!isPublic(type) || type.isAnnotation() || type.isAnonymousClass()) {
            return;
        }
        var entry = JavaLibrary.find(type.getCanonicalName());
        boolean isNewer = Runtime.version().feature() > 17 && entry.isEmpty();
        if (isNewer) {
            return;
        }
        assertThat(entry).as(type.getName()).isPresent();
        assertThat(entry.get().arguments())
                .as(type.getName())
                .isEqualTo(type.getTypeParameters().length);
        assertThat(entry.get().few())
                .as(type.getName())
                .isEqualTo(type.isEnum() || type == Void.class);
    }

    private static boolean isPublic(Class<?> type) {
        return Modifier.isPublic(type.getModifiers())
                && (type.getDeclaringClass() == null || isPublic(type.getDeclaringClass()));
    }
}
