package arcomat.sim.load;

import org.objectweb.asm.ClassReader;

import java.util.HashMap;
import java.util.Map;

/** What the classes of a program extend in the end. Names are internal ones. */
final class Superclasses {
    private static final String THREAD = "java/lang/Thread";

    private final Map<String, String> superclasses = new HashMap<>();

    Superclasses(Map<String, byte[]> classes) {
        for (byte[] classFile : classes.values()) {
            ClassReader reader = new ClassReader(classFile);
            superclasses.put(reader.getClassName(), reader.getSuperName());
        }
    }

    boolean isThread(String name) {
        String ancestor = name;
        while (ancestor != null && !ancestor.equals(THREAD)) {
            ancestor = superclasses.get(ancestor);
        }
        return ancestor != null;
    }

    /** Whether it can be thrown. */
    boolean isError(String name) {
        String ancestor = name;
        while (superclasses.containsKey(ancestor)) {
            ancestor = superclasses.get(ancestor);
        }
        return ancestor != null && ForeignCalls.isError(ancestor);
    }
}
