package arcomat.analysis.smt;

import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;

/**
 * Values that lie far apart: the first one of a type, and its ends. Of a class, the objects whose
 * attributes have such values, so that attributes of two objects differ by much.
 */
final class Ends implements Type.Cases<List<Value>> {
    /** So many objects of a class are tried; attributes behind those keep their first value. */
    private static final int OBJECTS = 30;

    @Override
    public List<Value> booleanType(Type.BooleanType type) {
        return List.of(type.first(), new Value.BooleanValue(true));
    }

    @Override
    public List<Value> integerType(Type.IntegerType type) {
        return distinct(
                type.first(),
                new Value.IntegerValue(type.high()),
                new Value.IntegerValue(type.low()));
    }

    @Override
    public List<Value> realType(Type.RealType type) {
        double end = type.below(Double.POSITIVE_INFINITY);
        return distinct(type.first(), new Value.RealValue(end), new Value.RealValue(-end));
    }

    @Override
    public List<Value> characterType(Type.CharacterType type) {
        return List.of(type.first());
    }

    @Override
    public List<Value> stringType(Type.StringType type) {
        return List.of(type.first());
    }

    @Override
    public List<Value> enumType(Type.EnumType type) {
        return distinct(type.first(), new Value.EnumValue(type, type.constants().size() - 1));
    }

    @Override
    public List<Value> classType(Type.ClassType type) {
        List<List<Value>> objects = List.of(List.of());
        for (Type.Attribute attribute : type.attributes()) {
            List<Value> ends = attribute.type().match(this);
            boolean many = objects.size() * ends.size() > OBJECTS;
            objects = with(objects, many ? ends.subList(0, 1) : ends);
        }
        return objects.stream()
                .<Value>map(attributes -> new Value.ObjectValue(type, attributes))
                .toList();
    }

    /** Each of some lists with each of some values behind. */
    private static List<List<Value>> with(List<List<Value>> objects, List<Value> ends) {
        List<List<Value>> longer = new ArrayList<>();
        for (List<Value> object : objects) {
            for (Value value : ends) {
                List<Value> more = new ArrayList<>(object);
                more.add(value);
                longer.add(more);
            }
        }
        return longer;
    }

    private static List<Value> distinct(Value... values) {
        return List.copyOf(new LinkedHashSet<>(List.of(values)));
    }
}
