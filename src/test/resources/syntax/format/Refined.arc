component Both refines p.Plain,Lamp( memory=true,alarm=! rich){feature rich;}
