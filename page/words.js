// The words of the page in the program's six languages.

/** @typedef {'en'|'de'|'fr'|'es'|'it'|'ja'} Language */

const languages = ['en', 'de', 'fr', 'es', 'it', 'ja'];

/** Each word in the order of `languages`. @type {Record<string, string[]>} */
const all_words = {
  play: ['Play', 'Abspielen', 'Lecture', 'Reproducir', 'Riproduci', '再生'],
  pause: ['Pause', 'Anhalten', 'Pause', 'Pausa', 'Pausa', '一時停止'],
  go_on: ['Go on', 'Weiter', 'Continuer', 'Continuar', 'Continua', '続ける'],
  previous_stop: ['Previous stop', 'Voriger Halt', 'Arrêt précédent', 'Parada anterior', 'Sosta precedente', '前の停止点'],
  next_stop: ['Next stop', 'Nächster Halt', 'Arrêt suivant', 'Parada siguiente', 'Sosta successiva', '次の停止点'],
  time: ['Time', 'Zeit', 'Temps', 'Tiempo', 'Tempo', '時間'],
  speed: ['Speed', 'Tempo', 'Vitesse', 'Velocidad', 'Velocità', '速度'],
  backwards: ['Backwards', 'Rückwärts', 'À rebours', 'Hacia atrás', 'All’indietro', '逆再生'],
  repeat: ['Repeat', 'Wiederholen', 'Répéter', 'Repetir', 'Ripeti', '繰り返し'],
  full_screen: ['Full screen', 'Vollbild', 'Plein écran', 'Pantalla completa', 'Schermo intero', '全画面'],
  options: ['Options', 'Einstellungen', 'Réglages', 'Opciones', 'Opzioni', '設定'],
  close: ['Close', 'Schließen', 'Fermer', 'Cerrar', 'Chiudi', '閉じる'],
  change: ['Change the motion', 'Bewegung ändern', 'Modifier le mouvement', 'Cambiar el movimiento', 'Modifica il moto', '運動を変える'],
  original: ['As in the scene', 'Wie in der Szene', 'Comme dans la scène', 'Como en la escena', 'Come nella scena', 'シーンの値に戻す'],
  show: ['Show', 'Anzeigen', 'Afficher', 'Mostrar', 'Mostra', '表示'],
  names: ['Names', 'Namen', 'Noms', 'Nombres', 'Nomi', '名前'],
  view: ['View', 'Ansicht', 'Vue', 'Vista', 'Vista', '視点'],
  scene_view: ['The scene’s view', 'Ansicht der Szene', 'Vue de la scène', 'Vista de la escena', 'Vista della scena', 'シーンの視点'],
  look: ['Colours', 'Farben', 'Couleurs', 'Colores', 'Colori', '配色'],
  of_scene: ['The scene’s', 'Der Szene', 'De la scène', 'De la escena', 'Della scena', 'シーン'],
  light: ['Light', 'Hell', 'Clair', 'Claro', 'Chiaro', 'ライト'],
  dark: ['Dark', 'Dunkel', 'Sombre', 'Oscuro', 'Scuro', 'ダーク'],
  save: ['Save and share', 'Speichern und teilen', 'Enregistrer et partager', 'Guardar y compartir', 'Salva e condividi', '保存と共有'],
  save_png: ['Save PNG', 'PNG speichern', 'Enregistrer en PNG', 'Guardar PNG', 'Salva PNG', 'PNG を保存'],
  save_svg: ['Save SVG', 'SVG speichern', 'Enregistrer en SVG', 'Guardar SVG', 'Salva SVG', 'SVG を保存'],
  width: ['Width', 'Breite', 'Largeur', 'Anchura', 'Larghezza', '幅'],
  height: ['Height', 'Höhe', 'Hauteur', 'Altura', 'Altezza', '高さ'],
  copy_link: ['Copy link', 'Link kopieren', 'Copier le lien', 'Copiar enlace', 'Copia link', 'リンクをコピー'],
  copied: ['Link copied', 'Link kopiert', 'Lien copié', 'Enlace copiado', 'Link copiato', 'リンクをコピーしました'],
  link: ['Link to this instant', 'Link zu diesem Augenblick', 'Lien vers cet instant', 'Enlace a este instante', 'Link a questo istante', 'この時刻へのリンク'],
  notes: ['Notes', 'Notizen', 'Notes', 'Notas', 'Note', 'ノート'],
  next: ['Next', 'Als Nächstes', 'Ensuite', 'Después', 'Poi', '次'],
  end: ['End', 'Ende', 'Fin', 'Fin', 'Fine', '終わり'],
  elapsed: ['Elapsed', 'Vergangen', 'Écoulé', 'Transcurrido', 'Trascorso', '経過'],
  keys: ['Keys', 'Tasten', 'Touches', 'Teclas', 'Tasti', 'キー'],
  figure: ['Figure', 'Bild', 'Figure', 'Figura', 'Figura', '図'],
  stop: ['Stop', 'Halt', 'Arrêt', 'Parada', 'Sosta', '停止点'],
  start_figure: ['Start the figure', 'Bild starten', 'Démarrer la figure', 'Iniciar la figura', 'Avvia la figura', '図を開始'],
  starting: ['Starting …', 'Startet …', 'Démarrage …', 'Iniciando …', 'Avvio …', '起動中…'],
  no_webgl: ['This browser offers no WebGL 2, so you see a still picture. A current browser with hardware acceleration shows the motion.',
    'Dieser Browser bietet kein WebGL 2; darum sehen Sie ein Standbild. Ein aktueller Browser mit Hardwarebeschleunigung zeigt die Bewegung.',
    'Ce navigateur n’offre pas WebGL 2 ; vous voyez donc une image fixe. Un navigateur récent avec accélération matérielle montre le mouvement.',
    'Este navegador no ofrece WebGL 2; por eso ve una imagen fija. Un navegador actual con aceleración por hardware muestra el movimiento.',
    'Questo browser non offre WebGL 2: per questo si vede un’immagine fissa. Un browser recente con accelerazione hardware mostra il moto.',
    'このブラウザーには WebGL 2 がないため、静止画を表示しています。ハードウェアアクセラレーションのある新しいブラウザーなら運動が見られます。'],
  no_wasm: ['WebAssembly is not available or not allowed here, so you see a still picture.',
    'WebAssembly fehlt hier oder ist nicht erlaubt; darum sehen Sie ein Standbild.',
    'WebAssembly est absent ou interdit ici ; vous voyez donc une image fixe.',
    'WebAssembly falta o no está permitido aquí; por eso ve una imagen fija.',
    'WebAssembly manca o non è consentito qui: per questo si vede un’immagine fissa.',
    'ここでは WebAssembly を使えないため、静止画を表示しています。'],
  no_start: ['The figure did not start, so you see a still picture.', 'Das Bild konnte nicht starten; darum sehen Sie ein Standbild.',
    'La figure n’a pas pu démarrer ; vous voyez donc une image fixe.', 'La figura no pudo iniciarse; por eso ve una imagen fija.',
    'La figura non si è avviata: per questo si vede un’immagine fissa.', '図を開始できなかったため、静止画を表示しています。'],
  lost: ['The graphics processor gave up. Click the figure to start it again.', 'Der Grafikprozessor hat abgebrochen. Klicken Sie auf das Bild, um es neu zu starten.',
    'Le processeur graphique a abandonné. Cliquez sur la figure pour la redémarrer.', 'El procesador gráfico se detuvo. Haga clic en la figura para reiniciarla.',
    'Il processore grafico si è fermato. Fate clic sulla figura per riavviarla.', '描画が中断しました。図をクリックすると再開します。'],
  key_play: ['play, pause, go on', 'abspielen, anhalten, weiter', 'lecture, pause, continuer', 'reproducir, pausar, continuar', 'riproduci, pausa, continua', '再生・一時停止・続ける'],
  key_frame: ['one frame', 'ein Einzelbild', 'une image', 'un fotograma', 'un fotogramma', '1 コマ'],
  key_stop: ['previous, next stop or chapter', 'voriger, nächster Halt oder Abschnitt', 'arrêt ou chapitre précédent, suivant', 'parada o capítulo anterior, siguiente', 'sosta o capitolo precedente, successivo', '前・次の停止点か章'],
  key_ends: ['beginning, end', 'Anfang, Ende', 'début, fin', 'principio, fin', 'inizio, fine', '最初・最後'],
  key_digits: ['chapter of that number', 'Abschnitt dieser Nummer', 'chapitre de ce numéro', 'capítulo de ese número', 'capitolo di quel numero', 'その番号の章'],
  key_speed: ['slower, faster', 'langsamer, schneller', 'plus lent, plus rapide', 'más lento, más rápido', 'più lento, più veloce', '遅く・速く'],
  key_turn: ['turn the view', 'Ansicht drehen', 'tourner la vue', 'girar la vista', 'ruotare la vista', '視点を回す'],
  key_pan: ['move the view', 'Ansicht verschieben', 'déplacer la vue', 'desplazar la vista', 'spostare la vista', '視点を動かす'],
  key_zoom: ['nearer, farther', 'näher, weiter', 'plus près, plus loin', 'más cerca, más lejos', 'più vicino, più lontano', '近く・遠く'],
  drag_omega: ['Drag the tip of ω to choose another polhode.', 'Ziehen Sie die Spitze von ω, um eine andere Polhodie zu wählen.',
    'Tirez la pointe de ω pour choisir une autre polhodie.', 'Arrastre la punta de ω para elegir otra polhodia.',
    'Trascinate la punta di ω per scegliere un’altra poloide.', 'ω の先を引くと別のポルホードを選べます。'],
};

/** The words in one language. */
class Words {
  /** @param {string} code */
  constructor(code) {
    this.code = languages.includes(code) ? code : 'en';
  }
  /** @param {string} name @returns {string} */
  of(name) {
    const row = all_words[name];
    return row?.[languages.indexOf(this.code)] ?? name;
  }
}
