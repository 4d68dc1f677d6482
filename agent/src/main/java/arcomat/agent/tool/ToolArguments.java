package arcomat.agent.tool;

import arcomat.pipeline.WrongUse;
import arcomat.source.Nearest;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** What a tool was told. Anybody may have written it: nothing is taken for what it should be. */
public final class ToolArguments {
    private final JsonObject values;

    private ToolArguments(JsonObject values) {
        this.values = values;
    }

    /**
     * @throws WrongUse where something is given that the tool does not know, or something is
     *     missing
     */
    public static ToolArguments of(JsonObject values, List<ToolParameter> parameters)
            throws WrongUse {
        List<String> names = parameters.stream().map(ToolParameter::name).toList();
        for (String given : values.keySet()) {
            if (!names.contains(given)) {
                throw new WrongUse(
                        "there is no argument '%s'%s; there are: %s",
                        given,
                        Nearest.hint(given, names),
                        names.isEmpty() ? "none" : String.join(", ", names));
            }
        }
        ToolArguments arguments = new ToolArguments(values);
        for (ToolParameter each : parameters) {
            if (each.required() && arguments.value(each.name()).isEmpty()) {
                throw new WrongUse("the argument '%s' is missing", each.name());
            }
        }
        return arguments;
    }

    private Optional<JsonElement> value(String name) {
        return Optional.ofNullable(values.get(name)).filter(value -> !value.isJsonNull());
    }

    Optional<String> text(String name) throws WrongUse {
        Optional<JsonElement> value = value(name);
        return value.isEmpty() ? Optional.empty() : Optional.of(text(name, value.get()));
    }

    /** Of an argument that has to be there. */
    String required(String name) throws WrongUse {
        return text(name).orElseThrow(() -> new WrongUse("the argument '%s' is missing", name));
    }

    private static String text(String name, JsonElement value) throws WrongUse {
        if (!value.isJsonPrimitive() || !value.getAsJsonPrimitive().isString()) {
            throw wrong(name, value, "a text");
        }
        return value.getAsString();
    }

    List<String> texts(String name) throws WrongUse {
        Optional<JsonElement> value = value(name);
        if (value.isEmpty()) {
            return List.of();
        }
        if (!value.get().isJsonArray()) {
            throw wrong(name, value.get(), "a list of texts");
        }
        List<String> texts = new ArrayList<>();
        for (JsonElement each : value.get().getAsJsonArray()) {
            texts.add(text(name, each));
        }
        return texts;
    }

    boolean flag(String name) throws WrongUse {
        Optional<JsonElement> value = value(name);
        if (value.isEmpty()) {
            return false;
        }
        if (!value.get().isJsonPrimitive() || !value.get().getAsJsonPrimitive().isBoolean()) {
            throw wrong(name, value.get(), "true or false");
        }
        return value.get().getAsBoolean();
    }

    /**
     * @throws WrongUse where it is not one of the values
     */
    String choice(String name, List<String> values) throws WrongUse {
        String chosen = text(name).orElse(values.get(0));
        if (!values.contains(chosen)) {
            throw new WrongUse(
                    "'%s' is '%s', and not one of: %s", name, chosen, String.join(", ", values));
        }
        return chosen;
    }

    /**
     * @throws WrongUse where it is no whole number from the least to the most
     */
    Optional<Long> number(String name, long least, long most) throws WrongUse {
        Optional<JsonElement> value = value(name);
        if (value.isEmpty()) {
            return Optional.empty();
        }
        long number = whole(name, value.get());
        if (number < least || number > most) {
            throw new WrongUse("'%s' is %d, and not from %d to %d", name, number, least, most);
        }
        return Optional.of(number);
    }

    /** Also one with a fraction of zero, since some programs know no other numbers. */
    private static long whole(String name, JsonElement value) throws WrongUse {
        try {
            if (value.isJsonPrimitive() && value.getAsJsonPrimitive().isNumber()) {
                return new BigDecimal(value.getAsString()).longValueExact();
            }
        } catch (NumberFormatException | ArithmeticException notWhole) {
            throw wrong(name, value, "a whole number");
        }
        throw wrong(name, value, "a whole number");
    }

    /** Texts by their names; numbers and truth values are taken as they are written. */
    Map<String, String> values(String name) throws WrongUse {
        Map<String, String> all = new LinkedHashMap<>();
        Optional<JsonElement> value = value(name);
        if (value.isPresent() && !value.get().isJsonObject()) {
            throw wrong(name, value.get(), "an object");
        }
        if (value.isPresent()) {
            for (Map.Entry<String, JsonElement> each : value.get().getAsJsonObject().entrySet()) {
                if (!each.getValue().isJsonPrimitive()) {
                    throw wrong(name, value.get(), "an object of texts");
                }
                all.put(each.getKey(), each.getValue().getAsString());
            }
        }
        return all;
    }

    private static WrongUse wrong(String name, JsonElement value, String wanted) {
        return new WrongUse("'" + name + "' is not " + wanted + ": " + value);
    }
}
