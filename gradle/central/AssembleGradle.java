import java.io.IOException;
import java.math.BigInteger;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.Comparator;
import java.util.stream.Stream;

/**
 * Rebuilds a runnable Gradle installation from the Maven Central artifact
 * dev.gradleplugins:gradle-api, the shaded "gradleApi()" jar of one release.
 *
 * <p>That jar is the concatenation of every module jar and every third-party jar of the
 * distribution, third-party packages moved below org.gradle.internal.impldep. This program undoes
 * both: it moves the packages back, and it cuts the list of entries into modules.
 *
 * <p>usage: java AssembleGradle LOCK_FILE JAR_FOLDER GRADLE_HOME, where the lock file has
 * sha256sum's format and JAR_FOLDER, some 190 MB, is removed at the end.
 */
public final class AssembleGradle {
    private AssembleGradle() {}

    public static void main(String[] args) throws IOException, GeneralSecurityException {
        Path jars = Path.of(args[1]);
        Path home = Path.of(args[2]);
        verifyChecksums(Path.of(args[0]), jars);

        Distribution distribution = new Distribution();
        ShadedJar.read(jar(jars, "gradle-api-"), distribution);
        ShadedJar.readModule("gradle-test-kit", jar(jars, "gradle-test-kit-"), distribution);
        AbsentParts.addTo(distribution);

        // Only a complete installation gets the name that gradlew looks for.
        Path unfinished = Path.of(home + ".part");
        delete(unfinished);
        new Installation(distribution, unfinished).write(jars);
        Files.move(unfinished, home);
        delete(jars);
        System.err.printf(
                "Gradle %s: %d modules, %d entries of libraries%n",
                distribution.version, distribution.modules.size(), distribution.thirdParty.size());
    }

    /** Every jar of the lock file has to be there with the recorded checksum. */
    private static void verifyChecksums(Path lockFile, Path jars)
            throws IOException, GeneralSecurityException {
        for (String line : Files.readAllLines(lockFile)) {
            if (line.isBlank() || line.startsWith("#")) {
                continue;
            }
            String[] fields = line.split("\\s+");
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            byte[] sum = digest.digest(Files.readAllBytes(jars.resolve(fields[1])));
            String actual = String.format("%064x", new BigInteger(1, sum));
            if (!actual.equals(fields[0])) {
                throw new IOException(
                        "checksum of " + fields[1] + " is " + actual + ", expected " + fields[0]);
            }
        }
    }

    private static Path jar(Path folder, String prefix) throws IOException {
        try (DirectoryStream<Path> found = Files.newDirectoryStream(folder, prefix + "*.jar")) {
            return found.iterator().next();
        }
    }

    static void delete(Path folder) throws IOException {
        if (Files.exists(folder)) {
            try (Stream<Path> paths = Files.walk(folder)) {
                for (Path path : paths.sorted(Comparator.reverseOrder()).toList()) {
                    Files.delete(path);
                }
            }
        }
    }
}
