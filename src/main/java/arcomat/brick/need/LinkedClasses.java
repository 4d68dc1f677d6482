package arcomat.brick.need;

import arcomat.brick.need.flow.MethodName;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * The classes of the linked program.
 *
 * @param number with those of the empty program
 * @param isExact whether all are known that the program names
 * @param names those beyond the empty program, and others of leJOS' that the program itself uses:
 *     internal names, of arrays descriptors
 */
record LinkedClasses(int number, boolean isExact, Set<String> names) {
    /** Classes of the empty program, as the linker counts them, with its main class. */
    static final int EMPTY_PROGRAM = 75;

    /** Primitive types are classes for the linker, and there is one that is reserved. */
    private static final int PRIMITIVE = 10;

    static LinkedClasses of(Code code, LibraryLinks library) {
        List<MethodName> mains =
                code.methods().stream().filter(method -> method.name().equals("main")).toList();
        // Where nobody calls a main method, all methods might be.
        Linked linked = Linked.from(mains.isEmpty() ? code.methods() : mains, code, library);
        Linked empty = Linked.from(List.of(), code, library);
        Set<String> names = new TreeSet<>(linked.names());
        names.removeAll(empty.names());
        int number = PRIMITIVE + linked.names().size();
        Set<String> used = new HashSet<>(linked.usedByProgram());
        used.retainAll(empty.names());
        names.addAll(used);
        return new LinkedClasses(number, linked.isComplete(), names);
    }
}
