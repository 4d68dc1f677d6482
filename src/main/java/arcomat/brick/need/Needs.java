package arcomat.brick.need;

import arcomat.brick.api.BrickTable;

import org.objectweb.asm.tree.ClassNode;

import java.util.Collection;
import java.util.OptionalInt;

/**
 * What a program needs of the brick.
 *
 * @param classes of the linked program, leJOS' own, arrays and primitive types included
 * @param isExact whether all that it uses of leJOS has been counted; an estimate otherwise
 * @param memory in bytes: objects, arrays, strings, statics and stacks, leJOS' own included
 * @param slice the longest one, in microseconds
 * @param cycle from one slice to the next, in milliseconds; none if that is not written as a number
 */
public record Needs(int classes, boolean isExact, Need memory, Need slice, OptionalInt cycle) {
    /** Classes of the empty program, as the linker counts them, its main class left out. */
    public static final int EMPTY_PROGRAM = LinkedClasses.EMPTY_PROGRAM;

    /**
     * @param classes those that could be read
     * @param table what is on the brick
     */
    public static Needs of(Collection<ClassNode> classes, BrickTable table) {
        Library library = Library.read();
        Code code = new Code(classes, table);
        Entry entry = new Entry(code);
        LinkedClasses linked = LinkedClasses.of(code, library, table);
        Memory memory = new Memory(code, library, entry, linked);
        SliceTime slice = new SliceTime(code, library, entry);
        return new Needs(
                linked.number(),
                linked.isExact(),
                Need.of(memory::bytes),
                Need.of(slice::worst),
                entry.cycle());
    }
}
