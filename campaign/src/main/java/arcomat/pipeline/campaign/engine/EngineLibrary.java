package arcomat.pipeline.campaign.engine;

import arcomat.pipeline.WrongUse;

import java.io.IOException;
import java.net.MalformedURLException;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;

/**
 * Where engines for clusters are found: on the class path, or in the folder {@code cluster} beside
 * the tool's jar. Nobody else loads anything of that folder: commands that need no cluster start as
 * if it were not there.
 */
public final class EngineLibrary {
    private static final String FOLDER = "cluster";

    private EngineLibrary() {}

    /**
     * @throws WrongUse where there is no engine for clusters
     */
    public static EngineProvider required() throws WrongUse {
        Optional<EngineProvider> given = first(EngineLibrary.class.getClassLoader());
        if (given.isPresent()) {
            return given.get();
        }
        return first(installed())
                .orElseThrow(
                        () ->
                                new WrongUse(
                                        "there is no engine for clusters: the folder lib/%s of the"
                                                + " installation is missing, or"
                                                + " arcomat-cluster-hazelcast on the class path",
                                        FOLDER));
    }

    private static Optional<EngineProvider> first(ClassLoader loader) {
        return ServiceLoader.load(EngineProvider.class, loader).findFirst();
    }

    private static ClassLoader installed() throws WrongUse {
        try {
            Path tool =
                    Path.of(
                            EngineLibrary.class
                                    .getProtectionDomain()
                                    .getCodeSource()
                                    .getLocation()
                                    .toURI());
            URL[] jars = jars(tool.resolveSibling(FOLDER)).toArray(new URL[0]);
            return new URLClassLoader(jars, EngineLibrary.class.getClassLoader());
        } catch (IOException | URISyntaxException e) {
            throw new WrongUse(
                    "the engine for clusters cannot be read: %s", String.valueOf(e.getMessage()));
        }
    }

    private static List<URL> jars(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        List<URL> jars = new ArrayList<>();
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*.jar")) {
            for (Path file : files) {
                jars.add(url(file));
            }
        }
        return jars;
    }

    private static URL url(Path file) throws MalformedURLException {
        return file.toUri().toURL();
    }
}
