package arcomat.sim.load;

import org.objectweb.asm.ClassReader;

import java.util.HashMap;
import java.util.Map;

/** Which classes of a program extend java.lang.Thread, directly or not. Names are internal ones. */
final class ThreadClasses {
    private static final String THREAD = "java/lang/Thread";

    private final Map<String, String> superclasses = new HashMap<>();

    ThreadClasses(Map<String, byte[]> classes) {
        for (byte[] classFile : classes.values()) {
            ClassReader reader = new ClassReader(classFile);
            superclasses.put(reader.getClassName(), reader.getSuperName());
        }
    }

    boolean contains(String name) {
        String ancestor = name;
        while (ancestor != null && !ancestor.equals(THREAD)) {
            ancestor = superclasses.get(ancestor);
        }
        return ancestor != null;
    }
}
