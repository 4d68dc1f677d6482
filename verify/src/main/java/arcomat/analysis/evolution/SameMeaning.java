package arcomat.analysis.evolution;

import arcomat.model.Component;
import arcomat.source.Span;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Whether two models say the same, wherever and however that is written: the records of the model
 * are compared, their places in the text are not. Comments, layout and the order of files cannot
 * make a difference, since a model does not hold them.
 */
final class SameMeaning {
    private static final ClassValue<Method[]> ACCESSORS =
            new ClassValue<>() {
                @Override
                protected Method[] computeValue(Class<?> type) {
                    return Arrays.stream(type.getRecordComponents())
                            .filter(each -> each.getType() != Span.class)
                            .map(RecordComponent::getAccessor)
                            .toArray(Method[]::new);
                }
            };

    private SameMeaning() {}

    /** What components say themselves; of the components of their parts only the names count. */
    static boolean own(Component one, Component other) {
        return records(one, other);
    }

    private static boolean same(Object one, Object other) {
        if (one == other || one instanceof Span && other instanceof Span) {
            return true;
        }
        if (one.getClass() != other.getClass()) {
            return one instanceof List<?> list && other instanceof List<?> more && all(list, more);
        }
        if (one instanceof Component part) {
            return part.qualifiedName().equals(((Component) other).qualifiedName());
        }
        if (one instanceof Record) {
            return records(one, other);
        }
        if (one instanceof List<?> list) {
            return all(list, (List<?>) other);
        }
        if (one instanceof Optional<?> value) {
            Optional<?> another = (Optional<?>) other;
            return value.isPresent() == another.isPresent()
                    && (value.isEmpty() || same(value.get(), another.get()));
        }
        return one.equals(other);
    }

    private static boolean all(List<?> one, List<?> other) {
        if (one.size() != other.size()) {
            return false;
        }
        for (int i = 0; i < one.size(); i++) {
            if (!same(one.get(i), other.get(i))) {
                return false;
            }
        }
        return true;
    }

    private static boolean records(Object one, Object other) {
        try {
            for (Method accessor : ACCESSORS.get(one.getClass())) {
                if (!same(accessor.invoke(one), accessor.invoke(other))) {
                    return false;
                }
            }
            return true;
        } catch (IllegalAccessException | InvocationTargetException impossible) {
            throw new AssertionError("the records of the model are public", impossible);
        }
    }
}
