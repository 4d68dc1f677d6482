package arcomat.docs;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;

/** The jars in the folder {@code lib} of the distribution, as the build tells its tests. */
final class DistributedJars {
    private DistributedJars() {}

    static List<Path> all() {
        String jars = System.getProperty("distribution.libraries");
        return Arrays.stream(jars.split(File.pathSeparator)).map(Path::of).toList();
    }

    static String sha256(Path file) throws IOException, GeneralSecurityException {
        byte[] digest = MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(file));
        return HexFormat.of().formatHex(digest);
    }
}
