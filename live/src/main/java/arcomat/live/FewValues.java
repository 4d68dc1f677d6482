package arcomat.live;

import arcomat.model.Type;

import java.util.List;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/**
 * The values of a type where they are so few that each can have a button; none where there are
 * more, and somebody has to write one.
 */
final class FewValues implements Type.Cases<List<String>> {
    private static final long MOST = 12;

    @Override
    public List<String> booleanType(Type.BooleanType type) {
        return Stream.of(true, false).map(String::valueOf).toList();
    }

    @Override
    public List<String> integerType(Type.IntegerType type) {
        boolean few = type.ranged() && type.high() - type.low() < MOST;
        return few
                ? LongStream.rangeClosed(type.low(), type.high()).mapToObj(String::valueOf).toList()
                : List.of();
    }

    @Override
    public List<String> realType(Type.RealType type) {
        return List.of();
    }

    @Override
    public List<String> characterType(Type.CharacterType type) {
        return List.of();
    }

    @Override
    public List<String> stringType(Type.StringType type) {
        return List.of();
    }

    @Override
    public List<String> enumType(Type.EnumType type) {
        return type.constants().size() <= MOST ? List.copyOf(type.constants()) : List.of();
    }

    @Override
    public List<String> classType(Type.ClassType type) {
        return List.of();
    }
}
