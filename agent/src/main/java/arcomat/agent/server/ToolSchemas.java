package arcomat.agent.server;

import arcomat.agent.tool.Tool;
import arcomat.agent.tool.ToolParameter;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;

import java.util.List;

/** Tools as agents are told of them. */
final class ToolSchemas {
    private ToolSchemas() {}

    static JsonObject list(List<Tool> tools) {
        JsonArray all = new JsonArray();
        tools.forEach(each -> all.add(of(each)));
        JsonObject list = new JsonObject();
        list.add("tools", all);
        return list;
    }

    private static JsonObject of(Tool tool) {
        JsonObject hints = new JsonObject();
        hints.addProperty("readOnlyHint", true);
        hints.addProperty("openWorldHint", false);
        JsonObject told = new JsonObject();
        told.addProperty("name", tool.name());
        told.addProperty("description", tool.description());
        told.add("inputSchema", schema(tool.parameters()));
        told.add("annotations", hints);
        return told;
    }

    private static JsonObject schema(List<ToolParameter> parameters) {
        JsonObject properties = new JsonObject();
        JsonArray required = new JsonArray();
        for (ToolParameter each : parameters) {
            properties.add(each.name(), each.schema());
            if (each.required()) {
                required.add(each.name());
            }
        }
        JsonObject schema = new JsonObject();
        schema.addProperty("type", "object");
        schema.add("properties", properties);
        if (!required.isEmpty()) {
            schema.add("required", required);
        }
        schema.addProperty("additionalProperties", false);
        return schema;
    }
}
