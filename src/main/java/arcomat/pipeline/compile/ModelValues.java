package arcomat.pipeline.compile;

import arcomat.generate.CodeLayout;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * What compiled code holds, as values of models.
 *
 * @param classes by the qualified name of the class of a class diagram
 */
record ModelValues(Map<String, CodeLayout.MessageClass> classes) {
    Value of(Object object, Type type) {
        return type.match(new FromJava(object));
    }

    private Value fromObject(Object object, Type.ClassType type) {
        List<String> fields = Objects.requireNonNull(classes.get(type.name())).attributes();
        List<Value> attributes = new ArrayList<>();
        for (int i = 0; i < type.attributes().size(); i++) {
            Object held = new Slot(object, fields.get(i)).get();
            attributes.add(of(held, type.attributes().get(i).type()));
        }
        return new Value.ObjectValue(type, attributes);
    }

    /** The value of each type that Java holds as this object. */
    private final class FromJava implements Type.Cases<Value> {
        private final Object object;

        FromJava(Object object) {
            this.object = object;
        }

        @Override
        public Value booleanType(Type.BooleanType type) {
            return new Value.BooleanValue((Boolean) object);
        }

        @Override
        public Value integerType(Type.IntegerType type) {
            return new Value.IntegerValue(((Number) object).longValue());
        }

        @Override
        public Value realType(Type.RealType type) {
            return new Value.RealValue(((Number) object).doubleValue());
        }

        @Override
        public Value characterType(Type.CharacterType type) {
            return new Value.CharacterValue((Character) object);
        }

        @Override
        public Value stringType(Type.StringType type) {
            return new Value.StringValue((String) object);
        }

        @Override
        public Value enumType(Type.EnumType type) {
            return new Value.EnumValue(type, (Integer) object - 1);
        }

        @Override
        public Value classType(Type.ClassType type) {
            return fromObject(object, type);
        }
    }
}
