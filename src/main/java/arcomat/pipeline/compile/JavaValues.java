package arcomat.pipeline.compile;

import arcomat.generate.CodeLayout;
import arcomat.model.Parameter;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.rt.Choice;

import java.util.ArrayList;
import java.util.List;

/** Values of models as compiled code holds them, and back. */
final class JavaValues {
    private final CompiledModel model;

    JavaValues(CompiledModel model) {
        this.model = model;
    }

    /** What the constructor of the whole takes. */
    List<Object> constructorArguments(List<Value> arguments, int seed) {
        List<Object> all = new ArrayList<>();
        if (model.place(model.component()).draws()) {
            all.add(new Choice(seed));
        }
        List<Parameter> parameters = model.component().parameters();
        for (int i = 0; i < parameters.size(); i++) {
            all.add(toJava(arguments.get(i), parameters.get(i).type()));
        }
        return all;
    }

    /** Enums become their codes, integers Java's int or long, objects those of their class. */
    Object toJava(Value value, Type type) {
        if (value instanceof Value.BooleanValue truth) {
            return truth.value();
        }
        if (value instanceof Value.IntegerValue integer) {
            return isLong(type) ? (Object) integer.value() : (Object) (int) integer.value();
        }
        if (value instanceof Value.RealValue real) {
            return isSingle(type) ? (Object) (float) real.value() : (Object) real.value();
        }
        if (value instanceof Value.CharacterValue character) {
            return character.value();
        }
        if (value instanceof Value.StringValue string) {
            return string.value();
        }
        if (value instanceof Value.EnumValue constant) {
            return constant.ordinal() + 1;
        }
        return object((Value.ObjectValue) value);
    }

    private Object object(Value.ObjectValue value) {
        List<Object> attributes = new ArrayList<>();
        for (int i = 0; i < value.attributes().size(); i++) {
            Type type = value.type().attributes().get(i).type();
            attributes.add(toJava(value.attributes().get(i), type));
        }
        String className = layout(value.type()).className();
        return model.instantiate(className, attributes);
    }

    private CodeLayout.MessageClass layout(Type.ClassType type) {
        return model.layout().classes().get(type.name());
    }

    Value fromJava(Object object, Type type) {
        if (type instanceof Type.BooleanType) {
            return new Value.BooleanValue((Boolean) object);
        }
        if (type instanceof Type.IntegerType) {
            return new Value.IntegerValue(((Number) object).longValue());
        }
        if (type instanceof Type.RealType) {
            return new Value.RealValue(((Number) object).doubleValue());
        }
        if (type instanceof Type.CharacterType) {
            return new Value.CharacterValue((Character) object);
        }
        if (type instanceof Type.StringType) {
            return new Value.StringValue((String) object);
        }
        if (type instanceof Type.EnumType enumeration) {
            return new Value.EnumValue(enumeration, (Integer) object - 1);
        }
        return fromObject(object, (Type.ClassType) type);
    }

    private Value fromObject(Object object, Type.ClassType type) {
        List<Value> attributes = new ArrayList<>();
        for (int i = 0; i < type.attributes().size(); i++) {
            String field = layout(type).attributes().get(i);
            attributes.add(
                    fromJava(new Slot(object, field).get(), type.attributes().get(i).type()));
        }
        return new Value.ObjectValue(type, attributes);
    }

    private static boolean isLong(Type type) {
        return type instanceof Type.IntegerType integer && integer.width() == Type.Width.LONG;
    }

    private static boolean isSingle(Type type) {
        return type instanceof Type.RealType real && real.single();
    }
}
