package arcomat.site;

import org.commonmark.node.Image;
import org.commonmark.node.Link;
import org.commonmark.node.Node;
import org.commonmark.renderer.html.AttributeProvider;

import java.util.Map;

/** What elements need to look right: pictures that are met later are loaded later. */
final class Looks implements AttributeProvider {
    @Override
    public void setAttributes(Node node, String tag, Map<String, String> attributes) {
        if (node instanceof Image) {
            attributes.put("loading", "lazy");
        }
        if (node instanceof Link link && link.getDestination().startsWith("https:")) {
            attributes.put("class", "outside");
            attributes.put("rel", "noreferrer");
        }
    }
}
