package arcomat.brick.need;

import arcomat.brick.api.BrickTable;
import arcomat.brick.need.flow.Unknown;

import org.jspecify.annotations.Nullable;
import org.objectweb.asm.tree.ClassNode;

import java.util.Collection;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.function.LongSupplier;

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
    /** What a linked program has room for. */
    public static final int MOST_CLASSES = 256;

    /** Classes of the empty program, as the linker counts them, with its main class. */
    public static final int EMPTY_PROGRAM = LinkedClasses.EMPTY_PROGRAM;

    /**
     * @param classes those that could be read
     * @param table what is on the brick
     */
    public static Needs of(Collection<ClassNode> classes, BrickTable table) {
        LibraryCost library = LibraryCost.read();
        Code code = new Code(classes, table);
        Entry entry = new Entry(code);
        LinkedClasses linked = LinkedClasses.of(code, LibraryLinks.read());
        Memory memory = new Memory(code, library, entry, linked);
        SliceTime slice = new SliceTime(code, library, entry);
        boolean isWatched = !new RobotMonitors(code, library).classes().isEmpty();
        return new Needs(
                linked.number(),
                linked.isExact(),
                Need.of(isWatched, memory::bytes),
                Need.of(isWatched || slice.isDrivenByEvents(), slice::worst),
                entry.cycle());
    }

    /**
     * How much of something a program needs, if that can be told from its code.
     *
     * @param amount none if it is not known
     * @param isBound whether it is never more, and may well be much less; about as much otherwise
     * @param unknown why it is not known: part of a sentence
     */
    public record Need(OptionalLong amount, boolean isBound, Optional<String> unknown) {
        static Need of(boolean isBound, LongSupplier amount) {
            try {
                return new Need(OptionalLong.of(amount.getAsLong()), isBound, Optional.empty());
            } catch (Unknown e) {
                return unknown(e.getMessage());
            } catch (ArithmeticException e) {
                return unknown("it is beyond all numbers");
            }
        }

        private static Need unknown(@Nullable String why) {
            return new Need(OptionalLong.empty(), false, Optional.ofNullable(why));
        }

        /** Whether it has to be taken for more than this. */
        public boolean isAbove(double limit) {
            return amount.isPresent() && !isBound && amount.getAsLong() > limit;
        }
    }
}
