package arcomat.agent.tool;

import arcomat.pipeline.WrongUse;

import java.util.List;

/** Something that an agent may ask for, and that changes nothing. */
public interface Tool {
    String name();

    /** What it is for, in words for who has to choose. */
    String description();

    List<ToolParameter> parameters();

    /**
     * @throws WrongUse where what is asked for does not fit what is there
     */
    ToolAnswer answer(ToolCall call) throws WrongUse;
}
