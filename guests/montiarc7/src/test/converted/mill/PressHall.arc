package mill;

component PressHall {
    feature careful, twice;
    constraint (!(careful <=> twice));
    port in Integer weight;
    port out Integer pressed;
    component Press(9, counting = false, slow = careful) first;
    connect weight -> first.weight;
    varif (twice) {
        component Press(counting = false, slow = true) second;
        connect first.pressed -> second.weight;
        connect second.pressed -> pressed;
    }
    varif (careful) {
        connect first.pressed -> pressed;
    }
}
