package arcomat.agent.tool;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;

import java.util.List;

/**
 * What a tool may be told, or has to be.
 *
 * @param schema what values it has, in the words of JSON Schema
 */
public record ToolParameter(String name, JsonObject schema, boolean required) {
    static final String PATHS = "paths";

    /** Of most tools: which models. */
    static ToolParameter paths() {
        return texts(
                PATHS,
                "Model files and folders, as findings name them; all model roots if absent.");
    }

    static ToolParameter text(String name, String description) {
        return new ToolParameter(name, type("string", description), false);
    }

    static ToolParameter texts(String name, String description) {
        JsonObject schema = type("array", description);
        schema.add("items", type("string"));
        return new ToolParameter(name, schema, false);
    }

    static ToolParameter flag(String name, String description) {
        return new ToolParameter(name, type("boolean", description), false);
    }

    static ToolParameter number(String name, long least, long most, String description) {
        JsonObject schema = type("integer", description);
        schema.addProperty("minimum", least);
        schema.addProperty("maximum", most);
        return new ToolParameter(name, schema, false);
    }

    static ToolParameter choice(String name, List<String> values, String description) {
        JsonObject schema = type("string", description);
        JsonArray all = new JsonArray();
        values.forEach(all::add);
        schema.add("enum", all);
        return new ToolParameter(name, schema, false);
    }

    /** Texts by names that somebody else has given. */
    static ToolParameter values(String name, String description) {
        JsonObject schema = type("object", description);
        schema.add("additionalProperties", type("string"));
        return new ToolParameter(name, schema, false);
    }

    /** The same, and it may not be absent. */
    ToolParameter asRequired() {
        return new ToolParameter(name, schema, true);
    }

    private static JsonObject type(String type, String description) {
        JsonObject schema = type(type);
        schema.addProperty("description", description);
        return schema;
    }

    private static JsonObject type(String type) {
        JsonObject schema = new JsonObject();
        schema.addProperty("type", type);
        return schema;
    }
}
