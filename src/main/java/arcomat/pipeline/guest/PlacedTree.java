package arcomat.pipeline.guest;

import arcomat.source.Span;

import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * A tree whose places are others: trees are records of records, lists and options, whatever
 * production they are of.
 *
 * @param places the other place of each
 */
record PlacedTree(UnaryOperator<Span> places) {
    /** The same tree elsewhere. */
    <T> T move(T tree) {
        @SuppressWarnings("unchecked") // each is moved to one of its own kind
        T moved = (T) moved(tree);
        return moved;
    }

    private Object moved(Object part) {
        if (part instanceof Span span) {
            return places.apply(span);
        }
        if (part instanceof List<?> list) {
            return list.stream().map(this::moved).toList();
        }
        if (part instanceof Optional<?> option) {
            return option.map(this::moved);
        }
        return part instanceof Record whole ? moved(whole) : part;
    }

    private Record moved(Record whole) {
        RecordComponent[] components = whole.getClass().getRecordComponents();
        try {
            Object[] values = new Object[components.length];
            for (int i = 0; i < components.length; i++) {
                values[i] = moved(components[i].getAccessor().invoke(whole));
            }
            Class<?>[] types =
                    Arrays.stream(components).map(RecordComponent::getType).toArray(Class[]::new);
            return whole.getClass().getConstructor(types).newInstance(values);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("a tree that is no open record: " + whole, e);
        }
    }
}
