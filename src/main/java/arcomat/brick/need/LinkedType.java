package arcomat.brick.need;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * A class as the linker sees it.
 *
 * @param parent internal name; none of java.lang.Object
 * @param methods by their signatures: names with descriptors
 * @param caught exceptions that are kept because some method has a handler for them, whether it is
 *     called or not: in this class and, of leJOS' classes, in all that they name
 * @param named other classes that it names, whose exceptions are kept, too
 */
record LinkedType(
        Optional<String> parent,
        List<String> interfaces,
        Map<String, Body> methods,
        Set<String> caught,
        Set<String> named) {

    /** What instructions of a method use. */
    record Body(boolean isStatic, List<Use> uses) {}

    /** How an instruction uses a class. */
    enum Kind {
        /** As that of an object that may be there, of an array, too. */
        OBJECT,
        /** For what belongs to the class itself. */
        CLASS,
        /** By a call of the method that is named. */
        DIRECT,
        /** By a call of what the class of the object has for it. */
        VIRTUAL,
        /** By a call of what implements the interface. */
        INTERFACE
    }

    /**
     * A use of a class.
     *
     * @param type internal name, or the descriptor of an array
     * @param signature of a method that is called; else empty
     */
    record Use(Kind kind, String type, String signature) {}
}
