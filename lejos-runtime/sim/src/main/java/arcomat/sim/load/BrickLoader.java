package arcomat.sim.load;

import arcomat.sim.device.Hardware;

import java.io.IOException;
import java.io.InputStream;

/**
 * The classes of one brick. What is static in a program or in lejos.* exists once per brick. A
 * program sees its own classes, lejos.* and the JDK, and nothing else of this process.
 */
public final class BrickLoader extends ClassLoader implements Hardware.Inside {
    private final Hardware hardware;
    private final Program program;
    private final Rewriter rewriter;

    public BrickLoader(Program program, Hardware hardware) {
        super("brick " + hardware.name(), BrickLoader.class.getClassLoader());
        for (String name : program.classes().keySet()) {
            if (isShared(name) || isInside(name)) {
                throw new IllegalArgumentException(name + " lies in a package of the simulation");
            }
        }
        this.hardware = hardware;
        this.program = program;
        this.rewriter = Rewriter.of(program.classes(), hardware.limits().counted());
    }

    @Override
    public Hardware hardware() {
        return hardware;
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        synchronized (getClassLoadingLock(name)) {
            Class<?> loaded = findLoadedClass(name);
            if (loaded != null) {
                return loaded;
            }
            return isShared(name) ? super.loadClass(name, resolve) : findClass(name);
        }
    }

    /** The JDK, and the simulation itself, where bricks meet. */
    private static boolean isShared(String name) {
        return name.startsWith("java.") || name.startsWith("arcomat.sim.") && !isInside(name);
    }

    private static boolean isInside(String name) {
        return isOfTheBrick(name) || name.startsWith("arcomat.sim.inside.");
    }

    /** Classes that are leJOS' for programs. */
    static boolean isOfTheBrick(String name) {
        return name.startsWith("lejos.") || name.startsWith("javax.microedition.");
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
        byte[] classFile = isInside(name) ? simulated(name) : ofProgram(name);
        return defineClass(name, classFile, 0, classFile.length);
    }

    private byte[] ofProgram(String name) throws ClassNotFoundException {
        byte[] classFile = program.classes().get(name);
        if (classFile == null) {
            throw new ClassNotFoundException(name + " is not in the program's jar");
        }
        return rewriter.rewrite(classFile);
    }

    private byte[] simulated(String name) throws ClassNotFoundException {
        String path = name.replace('.', '/') + ".class";
        try (InputStream stream = getParent().getResourceAsStream(path)) {
            if (stream == null) {
                throw new ClassNotFoundException(name + " is not simulated");
            }
            return stream.readAllBytes();
        } catch (IOException e) {
            throw new ClassNotFoundException(name + " cannot be read", e);
        }
    }
}
