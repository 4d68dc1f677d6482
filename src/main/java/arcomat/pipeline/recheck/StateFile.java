package arcomat.pipeline.recheck;

import arcomat.pipeline.PathNames;
import arcomat.report.text.Json;
import arcomat.source.Sha256;
import arcomat.source.SourceFile;

import com.fasterxml.jackson.annotation.JsonAutoDetect.Visibility;
import com.fasterxml.jackson.annotation.JsonValue;
import com.fasterxml.jackson.annotation.PropertyAccessor;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.json.JsonWriteFeature;
import com.fasterxml.jackson.databind.BeanProperty;
import com.fasterxml.jackson.databind.DeserializationContext;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JavaType;
import com.fasterxml.jackson.databind.JsonDeserializer;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.deser.ContextualDeserializer;
import com.fasterxml.jackson.databind.deser.std.StdDeserializer;
import com.fasterxml.jackson.databind.module.SimpleModule;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.nio.file.Files;
import java.util.Optional;

/**
 * The file that a check leaves behind: a digest of the rest in its first line, then the state as
 * JSON, for nobody but the tool that wrote it. One that is missing, damaged or written by another
 * tool is as good as none.
 *
 * @param file as the user wrote it
 */
public record StateFile(String file, PathNames names) {
    private static final ObjectMapper MAPPER =
            Json.mapper()
                    .visibility(PropertyAccessor.CREATOR, Visibility.ANY)
                    .enable(JsonWriteFeature.ESCAPE_NON_ASCII)
                    .enable(DeserializationFeature.FAIL_ON_NULL_CREATOR_PROPERTIES)
                    .addMixIn(SourceFile.class, ByPath.class)
                    .addModule(
                            new SimpleModule()
                                    .addDeserializer(SourceFile.class, new SourceDeserializer())
                                    .addDeserializer(
                                            Optional.class, new OptionalDeserializer(null)))
                    .build();

    /** Finds files by their paths, for the places of findings. */
    interface Sources {
        SourceFile at(String path);
    }

    Optional<CheckState> read(String key, Sources sources) {
        try {
            String text = Files.readString(names.resolve(file));
            int line = text.indexOf('\n');
            String state = text.substring(line + 1);
            return line >= 0 && Sha256.hex(state).equals(text.substring(0, line))
                    ? Optional.of(parse(state, sources)).filter(read -> read.key().equals(key))
                    : Optional.empty();
        } catch (IOException missing) {
            return Optional.empty();
        }
    }

    private static CheckState parse(String state, Sources sources) throws IOException {
        return MAPPER.readerFor(CheckState.class)
                .withAttribute(Sources.class, sources)
                .readValue(state);
    }

    /** What is to be written into the file. */
    public static String text(CheckState state) {
        try {
            String text = MAPPER.writeValueAsString(state);
            return Sha256.hex(text) + "\n" + text;
        } catch (JsonProcessingException e) {
            throw new AssertionError("texts and numbers can be written", e);
        }
    }

    /** How a file is written. */
    private interface ByPath {
        @JsonValue
        String path();
    }

    private static final class SourceDeserializer extends StdDeserializer<SourceFile> {
        private static final long serialVersionUID = 1L;

        SourceDeserializer() {
            super(SourceFile.class);
        }

        @Override
        public SourceFile deserialize(JsonParser json, DeserializationContext context)
                throws IOException {
            return ((Sources) context.getAttribute(Sources.class)).at(json.getText());
        }
    }

    /** What is there, or nothing where there is no field. */
    private static final class OptionalDeserializer extends StdDeserializer<Optional<?>>
            implements ContextualDeserializer {
        private static final long serialVersionUID = 1L;

        private final @Nullable JavaType content;

        OptionalDeserializer(@Nullable JavaType content) {
            super(Optional.class);
            this.content = content;
        }

        @Override
        public JsonDeserializer<?> createContextual(
                DeserializationContext context, BeanProperty property) {
            return new OptionalDeserializer(context.getContextualType().containedType(0));
        }

        @Override
        public Optional<?> deserialize(JsonParser json, DeserializationContext context)
                throws IOException {
            return Optional.of(context.readValue(json, content));
        }

        @Override
        public Optional<?> getNullValue(DeserializationContext context) {
            return Optional.empty();
        }
    }
}
