package mill;

component Sorter {
    timing instant;
    port in String kind, in Integer size;
    port out Integer box;
    Integer moved = 0;
    <<completion = "ignore">> automaton {
        state Small, Large;
        initial Small;
        Small -> Large [size > 10] / do {
            moved++;
            if (kind == "wood" || kind == "cork") {
                box = 1;
            } else if (kind == "iron") {
                box = 2;
            } else {
                box = 3 + moved;
            }
        };
        Small -> Small [size == 0 && !(size > 10)] / do {
            moved = 0;
            box = moved;
        };
        Large -> Large [size > 10] / do {
            box = 7;
        };
        Large -> Small [size == 0 && !(size > 10)] / do {
            moved = 0;
            box = moved;
        };
    }
}
