package arcomat.report.text;

import com.fasterxml.jackson.annotation.JsonAutoDetect.Visibility;
import com.fasterxml.jackson.annotation.JsonInclude;
import com.fasterxml.jackson.annotation.JsonInclude.Include;
import com.fasterxml.jackson.annotation.PropertyAccessor;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.ObjectWriter;
import com.fasterxml.jackson.databind.SerializerProvider;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.module.SimpleModule;
import com.fasterxml.jackson.databind.ser.std.StdSerializer;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Pattern;

/**
 * JSON text with a line break at its end. A record is an object: its components are the fields, in
 * their order, but for an optional one that is empty.
 */
public final class Json {
    private static final ObjectMapper MAPPER = mapper().build();
    private static final Pattern HALF_PAIR = Pattern.compile("\\p{Cs}");

    private Json() {}

    /** Writes records as all JSON is written; for who has more to say about it. */
    public static JsonMapper.Builder mapper() {
        JsonInclude.Value present = JsonInclude.Value.construct(Include.NON_EMPTY, null);
        return JsonMapper.builder()
                .visibility(PropertyAccessor.ALL, Visibility.NONE)
                .visibility(PropertyAccessor.FIELD, Visibility.ANY)
                .withConfigOverride(Optional.class, each -> each.setInclude(present))
                .addModule(form(Optional.class, Json::present));
    }

    private static @Nullable Object present(Optional<?> optional) {
        return optional.orElse(null);
    }

    /**
     * To write something as something else.
     *
     * @param form no field where that is null
     */
    public static <T> SimpleModule form(Class<T> type, Function<T, ?> form) {
        return new SimpleModule().addSerializer(new FormSerializer<>(type, form));
    }

    /** With two blanks of indentation. */
    public static String text(Object value) {
        return text(indented(), value);
    }

    /** On one line. */
    public static String compact(Object value) {
        return text(MAPPER.writer(), value);
    }

    private static String text(ObjectWriter writer, Object value) {
        StringWriter out = new StringWriter();
        try {
            writer.writeValue(out, value);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return escapeHalfPairs(out.append('\n').toString());
    }

    private static ObjectWriter indented() {
        DefaultIndenter indenter = new DefaultIndenter("  ", "\n");
        return MAPPER.writer(
                new DefaultPrettyPrinter()
                        .withObjectIndenter(indenter)
                        .withArrayIndenter(indenter));
    }

    /** A part of a value, piece by piece. */
    public interface Part {
        void write(JsonGenerator json) throws IOException;
    }

    /** A text that is taken away while it grows; with two blanks of indentation. */
    public static final class Growing {
        private final StringWriter out = new StringWriter();
        private final JsonGenerator json;

        public Growing() {
            try {
                json = indented().createGenerator(out);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        /** What has come to the text, half a value perhaps, but a whole text. */
        public String add(Part part) {
            try {
                part.write(json);
                json.flush();
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
            String added = escapeHalfPairs(out.toString());
            out.getBuffer().setLength(0);
            return added;
        }
    }

    /** Half of a surrogate pair, which models may send, has no encoding but an escape. */
    private static String escapeHalfPairs(String json) {
        return HALF_PAIR
                .matcher(json)
                .replaceAll(half -> String.format("\\\\u%04x", half.group().codePointAt(0)));
    }

    private static final class FormSerializer<T> extends StdSerializer<T> {
        private static final long serialVersionUID = 1L;

        private final transient Function<T, ?> form;

        FormSerializer(Class<T> type, Function<T, ?> form) {
            super(type);
            this.form = form;
        }

        @Override
        public boolean isEmpty(SerializerProvider provider, T value) {
            return form.apply(value) == null;
        }

        @Override
        public void serialize(T value, JsonGenerator json, SerializerProvider provider)
                throws IOException {
            provider.defaultSerializeValue(form.apply(value), json);
        }
    }
}
