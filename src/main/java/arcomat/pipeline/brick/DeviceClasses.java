package arcomat.pipeline.brick;

import arcomat.pipeline.compile.ClassFiles;
import arcomat.sim.bus.I2CDevice;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;

/** What the description of a device may refer to: Java itself, and what a device has to be. */
final class DeviceClasses implements ClassFiles {
    private static final String JAVA = "java/";
    private static final String BUS = I2CDevice.class.getPackageName().replace('.', '/');

    private final Set<String> packages = new HashSet<>();

    DeviceClasses() {
        Object.class.getModule().getPackages().forEach(name -> add(name.replace('.', '/')));
        add(BUS);
    }

    private void add(String name) {
        for (int end = name.length(); end > 0; end = name.lastIndexOf('/', end - 1)) {
            packages.add(name.substring(0, end));
        }
    }

    @Override
    public Optional<byte[]> find(String name) {
        if (!name.startsWith(JAVA) && !name.startsWith(BUS + "/")) {
            return Optional.empty();
        }
        ClassLoader loader = I2CDevice.class.getClassLoader();
        try (InputStream in = loader.getResourceAsStream(name + ".class")) {
            return in == null ? Optional.empty() : Optional.of(in.readAllBytes());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public boolean isPackage(String name) {
        return packages.contains(name);
    }
}
