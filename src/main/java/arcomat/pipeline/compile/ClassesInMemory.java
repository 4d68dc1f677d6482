package arcomat.pipeline.compile;

import java.util.Map;

/**
 * Loads classes that were compiled in memory; what they need besides is in the tool. A model may
 * use package names of the tool; its own classes come first.
 */
public final class ClassesInMemory extends ClassLoader {
    private final Map<String, byte[]> classes;

    /**
     * @param classes class files by internal name ({@code p/Robot})
     */
    public ClassesInMemory(Map<String, byte[]> classes) {
        super(ClassesInMemory.class.getClassLoader());
        this.classes = classes;
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        synchronized (getClassLoadingLock(name)) {
            byte[] file = classes.get(name.replace('.', '/'));
            if (file == null) {
                return super.loadClass(name, resolve);
            }
            Class<?> known = findLoadedClass(name);
            return known != null ? known : defineClass(name, file, 0, file.length);
        }
    }
}
